#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "slam/geometry/polygon2.h"

namespace ariadne::slam {

/// Triangles in the plane over shared vertices, counterclockwise.
struct Triangles2 {
  std::vector<Eigen::Vector2d> vertices;  // [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The area of polygons with holes as triangles: cut into trapezoids at the corners (Boost.Polygon), and
/// these along a diagonal. Corners are rounded to 0.1 mm. Error for coordinates beyond 100 km, or NaN.
Triangles2 Triangulated(std::span<const Polygon2> polygons);

}  // namespace ariadne::slam
