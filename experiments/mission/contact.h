#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control/drive_limits.h"
#include "drivers/robot.h"

namespace ariadne::experiments {

/// What safety scanners saw, in the base frame, from above; without no-returns.
std::vector<Eigen::Vector2d> PointsOf(std::span<const drivers::SafetySweep> sweeps);

/// What the robot touches [m, base frame]: the nearest thing that the safety scanners see within 10 cm of
/// its outline; where they see none, the side or corner that the command moved, 5 cm further out.
Eigen::Vector2d ContactPlace(drivers::Robot& robot, const control::DriveCommand& command);

}  // namespace ariadne::experiments
