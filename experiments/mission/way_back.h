#pragma once

#include <span>
#include <vector>

#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

/// What has been driven, from its last pose backwards, without what was driven to and fro, up to the first
/// pose that is farther from the last one than `reach` [m].
std::vector<slam::Pose2> WayBack(std::span<const slam::Pose2> driven_map, double reach);

}  // namespace ariadne::experiments
