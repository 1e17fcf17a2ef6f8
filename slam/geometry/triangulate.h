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

/// The area of polygons with holes as triangles: cut into trapezoids at the heights of the corners, and
/// these along a diagonal. Corners are rounded to 0.1 mm. Rings may touch and cross, as the slivers of a
/// noisy union do when they are rounded: what lies in more outer rings than holes counts, and near a
/// crossing the area errs by less than that of the triangle between it and the next corner. (Boost.Polygon,
/// which cuts into trapezoids too, crashes at some of these.) Error for coordinates beyond 100 km, or NaN.
Triangles2 Triangulated(std::span<const Polygon2> polygons);

}  // namespace ariadne::slam
