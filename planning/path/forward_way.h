#pragma once

#include <functional>
#include <vector>

#include "planning/path/footprint.h"
#include "planning/path/geodesic.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning::internal {

/// Where a robot that only goes forward is free on the way, straight or on an arc, from one pose to
/// another.
using IsForwardFree = std::function<bool(const slam::Pose2& from, const slam::Pose2& to)>;

/// The corners of a way forward, on arcs of a radius [m] and straight lines, each corner on the shortest
/// such way from the one before; by hybrid A* (Dolgov et al., IJRR 29(5), 2010) over places of 10 cm and
/// headings of 7.5 deg, led by the ways of a disc from the goal. It finds where RRT-Connect does not that a
/// robot has to go round in a loop first, and soon ends where the robot stands such that it can leave only
/// backward. Empty: there is none at this resolution, or none among so many poses.
std::vector<slam::Pose2> ForwardWay(const GeodesicField& from_goal, const Footprint& footprint,
                                    const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                    double turning_radius, const IsForwardFree& is_free, std::size_t most);

}  // namespace ariadne::planning::internal
