#pragma once

#include <Eigen/Core>
#include <vector>

#include "control/drive_limits.h"
#include "drivers/robot.h"

namespace ariadne::experiments {

/// How the base has moved since the end of a sweep, by how it moves now: T_then_now. No motion where the
/// sweep has just ended.
slam::Pose2 MovedSince(const slam::LaserSweep& sweep, const slam::ScannerModel& scanner,
                       const drivers::RobotState& now);

/// What the safety scanners see now, in the base frame, from above; without no-returns. Where the robot has
/// none, the horizontal sweep of the 3D scanner, whose model is `scanner`.
std::vector<Eigen::Vector2d> SafetyPoints(drivers::Robot& robot, const slam::ScannerModel& scanner);

/// What the robot touches [m, base frame]: the nearest thing that the safety scanners see within 10 cm of
/// its outline; where they see none, the side or corner that the command moved, 5 cm further out.
Eigen::Vector2d ContactPlace(drivers::Robot& robot, const slam::ScannerModel& scanner,
                             const control::DriveCommand& command);

}  // namespace ariadne::experiments
