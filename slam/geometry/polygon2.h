#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace ariadne::slam {

/// Corners in order; the last is joined to the first [m].
using Ring = std::vector<Eigen::Vector2d>;

/// An area with holes. The outer ring runs counterclockwise, holes clockwise.
struct Polygon2 {
  Ring outer;
  std::vector<Ring> holes;
};

/// Positive where the ring runs counterclockwise [m^2].
double SignedArea(const Ring& ring);

/// Without its holes [m^2].
double Area(const Polygon2& polygon);

/// Length of all edges, those of holes included [m].
double Perimeter(const Polygon2& polygon);

/// True within, and not within a hole.
bool Contains(const Polygon2& polygon, const Eigen::Vector2d& p);

/// The areas that any of the rings encloses, whatever the sense in which it runs (Vatti's algorithm,
/// Sec. 2.2.1). Corners are rounded to 0.1 mm; what is thinner than that vanishes.
std::vector<Polygon2> United(std::span<const Ring> rings);

/// The same of polygons with holes.
std::vector<Polygon2> United(std::span<const Polygon2> polygons);

}  // namespace ariadne::slam
