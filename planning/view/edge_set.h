#pragma once

#include <span>
#include <vector>

#include "slam/geometry/polygon2.h"

namespace ariadne::planning {

/// A piece of the boundary of what is known, in the map frame [m]. Seen edges are walls; unseen ones join
/// the ends of walls and hide what no scan has reached (Sec. 4.2).
struct Edge {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  bool seen = false;
};

/// The edges of all rings, with one label.
std::vector<Edge> EdgesOf(const slam::Polygon2& polygon, bool seen);

/// From a place to the nearest point of an edge [m].
double Distance(const Edge& edge, const Eigen::Vector2d& p_map);

/// Error where an edge has an end that is no place, or is farther than 100,000 km from the origin.
void RequirePlaces(std::span<const Edge> edges);

/// The same of places; `what` names them in the error ("candidate").
void RequirePlaces(std::span<const Eigen::Vector2d> places, const char* what);

}  // namespace ariadne::planning
