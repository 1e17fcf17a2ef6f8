#pragma once

#include <cstddef>
#include <span>

#include "planning/path/footprint.h"

namespace ariadne::experiments {

/// [m]
double LengthOf(std::span<const slam::Pose2> poses);

/// How many poses of a path come before the first at which the robot touches what is not free of the space.
std::size_t ClearPoses(std::span<const slam::Pose2> path, const planning::FreeSpace& space,
                       const planning::FootprintOptions& footprint);

}  // namespace ariadne::experiments
