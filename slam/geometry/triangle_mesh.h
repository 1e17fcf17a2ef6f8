#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "slam/geometry/rgb.h"

namespace ariadne::slam {

/// Triangles over shared vertices, counterclockwise seen from outside where they have an outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;  // [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Rgb> colors = {};  // empty, or one per vertex
};

/// Adds the triangles of `tail`. Colours survive where both have them, or where one is empty.
void Append(TriangleMesh& mesh, const TriangleMesh& tail);

}  // namespace ariadne::slam
