#pragma once

#include <span>
#include <vector>

#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

/// What has been driven, from its last pose backwards, without what was driven to and fro, up to the first
/// pose that is farther from the last one than `reach` [m]. Small steps aside, by which the localization
/// was corrected, are left out: nobody can drive them.
std::vector<slam::Pose2> WayBack(std::span<const slam::Pose2> driven_map, double reach);

/// Adds what has been driven to a trail, which keeps its last 10,000 poses: without the time that the robot
/// stood.
void AddToTrail(std::span<const slam::Pose2> driven_map, std::vector<slam::Pose2>& trail_map);

}  // namespace ariadne::experiments
