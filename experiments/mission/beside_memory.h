#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "drivers/robot.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

/// What the scanners have seen nearby and cannot see from where the robot is now: they look ahead and
/// behind, and what a robot passes is beside it, where it turns into it. Each height has its own: a scanner
/// that looks over a thing has not seen that it is gone. Odometry errs by millimetres on the few metres
/// that this is kept for.
class BesideMemory {
 public:
  /// The points of the sweeps, and those of earlier ones that are beside the robot now; base frame of now
  /// [m].
  std::vector<Eigen::Vector2d> Update(std::span<const drivers::SafetySweep> sweeps,
                                      const drivers::RobotState& now);

 private:
  std::vector<Eigen::Vector3d> near_odom_;
};

}  // namespace ariadne::experiments
