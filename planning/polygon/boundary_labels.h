#pragma once

#include <span>
#include <vector>

#include "planning/polygon/labelled_polygon.h"

namespace ariadne::planning {

/// How far the edges of a union may lie from those that it was made of: corners and crossings are on a grid
/// of 1 micrometre [m].
constexpr double kUnionRounding = 1e-5;

/// An edge of a polygon, with the polygon's area on its left.
struct DirectedEdge {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  bool seen = false;
};

/// Of all polygons, also of those whose rings run the other way round. Edges without length are left out.
std::vector<DirectedEdge> DirectedEdges(std::span<const LabelledPolygon> polygons);

/// A part of an edge, in metres from its first corner.
struct Stretch {
  double begin = 0.0, end = 0.0;
};

/// Which parts of an edge are seen, told from the edges of the polygons whose union it bounds. Of the edges
/// that lie along it within kUnionRounding, the outermost is the one that it was made
/// of; of those that lie on each other (to 10 nm), a seen one. `p` is where it begins and `along` its
/// direction (a unit vector) [m].
std::vector<Stretch> SeenStretches(const Eigen::Vector2d& p, const Eigen::Vector2d& along, double length,
                                   std::span<const DirectedEdge> edges);

/// The parts along which a seen edge runs in nearly the same direction (angles below `max_angle` [rad]) and
/// not farther away than `distance` [m].
std::vector<Stretch> StretchesNearSeen(const Eigen::Vector2d& p, const Eigen::Vector2d& along,
                                       double length, std::span<const DirectedEdge> edges, double distance,
                                       double max_angle);

}  // namespace ariadne::planning
