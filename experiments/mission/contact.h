#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control/drive_limits.h"
#include "drivers/robot.h"

namespace ariadne::experiments {

/// How the base has moved since the end of a sweep, by how it moves now: T_then_now. No motion where the
/// sweep has just ended.
slam::Pose2 MovedSince(const slam::LaserSweep& sweep, const slam::ScannerModel& scanner,
                       const drivers::RobotState& now);

/// What the safety scanners see now. A robot that has none looks with its 3D scanner in horizontal mode,
/// whose model is `scanner`; where that saw something is told in the base frame of now.
std::vector<drivers::SafetySweep> LookAround(drivers::Robot& robot, const slam::ScannerModel& scanner,
                                             const drivers::RobotState& now);

/// What safety scanners saw, in the base frame, from above; without no-returns.
std::vector<Eigen::Vector2d> PointsOf(std::span<const drivers::SafetySweep> sweeps);

/// What the robot touches [m, base frame]: the nearest thing that the safety scanners see within 10 cm of
/// its outline; where they see none, the side or corner that the command moved, 5 cm further out.
Eigen::Vector2d ContactPlace(drivers::Robot& robot, const slam::ScannerModel& scanner,
                             const control::DriveCommand& command);

}  // namespace ariadne::experiments
