#pragma once

#include <span>
#include <vector>

#include "planning/path/footprint.h"

namespace ariadne::planning::internal {

/// The shortest chain of poses from near a start to near a goal in each of which the robot fits, on a
/// raster of places and headings: steps forward or backward to the next place, and turns on the spot.
/// Complete but for its resolution (that of the space, 10 deg), so that a way is found also where the
/// shortest one of a disc leads through what the rectangle cannot turn in. Takes 7 bytes for
/// each pose of the space. Empty: there is none, it takes more than `most` poses to find it, or the space
/// has more than 2.7 million cells.
std::vector<slam::Pose2> PosesOnRaster(const FreeSpace& space, const Footprint& footprint,
                                       const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                       std::size_t most);

/// Which of the goals such a chain leads to; all, where the space has too many cells to tell.
std::vector<bool> GoalsOnRaster(const FreeSpace& space, const Footprint& footprint,
                                const slam::Pose2& T_map_start, std::span<const slam::Pose2> T_map_goals);

}  // namespace ariadne::planning::internal
