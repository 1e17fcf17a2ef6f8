#pragma once

#include <vector>

#include "planning/path/free_space.h"
#include "planning/view/edge_set.h"

namespace ariadne::planning {

/// Places from which unseen edges can be looked at from near by: before each, a metre apart along it, as
/// near to it as a disc of that radius can be. The longest edges first; edges must have the area to their
/// left.
std::vector<Eigen::Vector2d> FrontierPlaces(std::span<const Edge> edges, const FreeSpace& free,
                                            double radius);

}  // namespace ariadne::planning
