#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "control/pure_pursuit.h"
#include "drivers/robot.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

struct DriveOptions {
  control::FollowOptions follow;
  double back_off = 0.2;
  double max_time = 300.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("follow", self.follow, "the controller that follows a path");
    visit("back_off", self.back_off, Unit("m"), Range{0.0, 2.0},
          "from what the robot has touched, before anything else is planned");
    visit("max_time", self.max_time, Unit("s"), Range{1.0, 1e5},
          "for one path, after which it is given up");
  }
};

enum class DriveEnd {
  kArrived,
  kBlocked,  // something stands in the way, and did not go away
  kStopped   // the mission was stopped; the wheels stand
};

struct DriveReport {
  DriveEnd end = DriveEnd::kArrived;
  std::vector<Eigen::Vector2d> obstacles_map;  // that were met
  std::vector<slam::Pose2> poses_map;          // driven, by odometry
  double length = 0.0;                         // [m]
};

/// Drives a path by odometry alone. `T_map_odom` says where the odometry's frame lies in the map; whatever
/// errs, it or the wheels, is not corrected on the way. Where something holds the wheels, the robot backs
/// off by the way that it came. `stop` is asked before each command.
DriveReport DrivePath(drivers::Robot& robot, const slam::Pose2& T_map_odom,
                      const std::vector<slam::Pose2>& path_map, const DriveOptions& options,
                      const std::function<bool()>& stop);

}  // namespace ariadne::experiments
