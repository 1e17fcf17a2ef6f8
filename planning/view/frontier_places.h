#pragma once

#include <vector>

#include "planning/path/free_space.h"
#include "planning/view/edge_set.h"

namespace ariadne::planning {

/// Where to stand before an unseen edge.
enum class FrontierSide {
  kBefore,  // straight before it
  kAside,   // on either side of that: what lies before an edge across a corridor may be a wall
};

/// Places from which unseen edges can be looked at from near by: before each, or on eight directions aside
/// of that, a metre apart along it, as near to it as a disc of that radius can be. The longest edges first;
/// edges must have the area to their left.
std::vector<Eigen::Vector2d> FrontierPlaces(std::span<const Edge> edges, const FreeSpace& free,
                                            double radius, FrontierSide side);

}  // namespace ariadne::planning
