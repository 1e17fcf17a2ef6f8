#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control/drive_limits.h"
#include "drivers/robot.h"

namespace ariadne::experiments {

/// Where the scanner was when it measured a beam, by how the base moves now: T_base_laser of then in the
/// base frame of now. A sweep takes 13 ms and more: who turns at 0.6 rad/s has turned by 8 mrad meanwhile.
slam::Pose3 LaserAtBeam(const drivers::SafetySweep& sweep, std::size_t beam,
                        const drivers::RobotState& now);

/// What a sweep saw, each beam from where the scanner was then; in the base frame of now, without
/// no-returns.
std::vector<Eigen::Vector3d> PointsOf(const drivers::SafetySweep& sweep, const drivers::RobotState& now);

/// The same of several, from above.
std::vector<Eigen::Vector2d> PlacesOf(std::span<const drivers::SafetySweep> sweeps,
                                      const drivers::RobotState& now);

/// What the safety scanners see now, if there are any, and the 3D scanner in horizontal mode, whose model
/// is `scanner`: the ones see legs, the other the arms and hips above them.
std::vector<drivers::SafetySweep> LookAround(drivers::Robot& robot, const slam::ScannerModel& scanner);

/// What the robot touches [m, base frame]: the nearest thing that the scanners see within 10 cm of
/// its outline; where they see none, the side or corner that the command moved, 5 cm further out.
Eigen::Vector2d ContactPlace(drivers::Robot& robot, const slam::ScannerModel& scanner,
                             const control::DriveCommand& command);

}  // namespace ariadne::experiments
