#pragma once

#include <cstddef>
#include <vector>

#include "experiments/report/viewer_scene.h"

namespace ariadne::experiments {

/// Points that are left, and the edge of the cubes of which each holds one per scan; 0: all are left [m].
struct ThinnedPoints {
  std::vector<ViewerPoint> points;
  double spacing = 0.0;
};

/// At most `max_points`: the first of each scan in each cube, in the given order. The cubes are the
/// smallest of a series that does. Points must be finite.
ThinnedPoints ThinPoints(std::vector<ViewerPoint> points, std::size_t max_points);

/// A mesh with at most `max_triangles`: corners in one cube become the first of them, and triangles without
/// area vanish.
struct ThinnedMesh {
  slam::TriangleMesh mesh_map;
  double spacing = 0.0;  // edge of the cubes; 0: the mesh as it was [m]
};

ThinnedMesh ThinMesh(slam::TriangleMesh mesh_map, std::size_t max_triangles);

}  // namespace ariadne::experiments
