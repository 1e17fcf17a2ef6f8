#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "drivers/robot.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

struct DriveOutcome {
  bool blocked = false;                        // the way was not driven to its end
  std::optional<Eigen::Vector2d> contact_map;  // where something stands in the way
};

/// Drives a way by odometry alone: turns on the spot, goes straight to each of the places, and turns to a
/// heading [rad] at the end. `T_map_odom` says where the odometry's frame lies in the map; whatever errs,
/// it or the wheels, is not corrected on the way. A contact that stops a turn is left by up to four strokes
/// of 20 cm, ahead or back; one ahead ends the way, and the robot goes back by 20 cm. The contact is the
/// nearest thing that the safety scanners see within 10 cm of the robot's outline, else 5 cm beyond the
/// side or corner that moved.
DriveOutcome DriveWay(drivers::Robot& robot, const slam::Pose2& T_map_odom,
                      std::span<const Eigen::Vector2d> way_map, double heading_map);

}  // namespace ariadne::experiments
