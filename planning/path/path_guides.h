#pragma once

#include <vector>

#include "planning/path/footprint.h"
#include "planning/path/geodesic.h"

namespace ariadne::planning::internal {

/// What a planner of paths draws from: poses along a way, and places.
struct PathSamples {
  std::vector<slam::Pose2> guides;
  std::vector<Eigen::Vector2d> cells;  // centres of those that can be reached [m]
  double cell = 0.0;                   // their size [m]
};

/// Poses T_map_robot in which the robot fits, along the shortest way of a disc within it, but moved to the
/// middle of what is narrow and turned into it: through a door of 0.8 m only few poses lead.
std::vector<slam::Pose2> FindGuides(const FreeSpace& space, const Footprint& footprint,
                                    const GeodesicField& reachable, const slam::Pose2& T_map_start,
                                    const slam::Pose2& T_map_goal);

/// Guides that far apart [m] with the most room around them.
std::vector<std::size_t> StopsAmong(const FreeSpace& space, const std::vector<slam::Pose2>& guides,
                                    double least, double most);

/// Cells in the box of the guides and around it [m].
PathSamples SamplesOf(const FreeSpace& space, const GeodesicField& reachable,
                      const std::vector<slam::Pose2>& guides, double around);

}  // namespace ariadne::planning::internal
