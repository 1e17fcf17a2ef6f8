#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "control/approach_step.h"
#include "control/avoidance.h"
#include "control/pure_pursuit.h"
#include "drivers/robot.h"
#include "experiments/mission/localizer.h"
#include "experiments/mission/moving_things.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {

struct DriveOptions {
  control::FollowOptions follow;
  LocalizerOptions localize;
  bool avoid_obstacles = true;
  control::AvoidanceOptions avoid;
  MovingThingsOptions moving;
  double known_within = 2.0;
  double patience = 4.0;
  double back_off = 0.5;
  double max_time = 300.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("follow", self.follow, "the controller that follows a path");
    visit("localize", self.localize, "how odometry is corrected on the way");
    visit("avoid_obstacles", self.avoid_obstacles,
          "look with the safety scanners while driving, and give way (5.3)");
    visit("avoid", self.avoid, "how the robot gives way");
    visit("moving", self.moving, "what walks into the robot's way");
    visit("known_within", self.known_within, Unit("m"), Range{0.0, 100.0},
          "of the robot, obstacles of the map count too: the safety scanners look below tables");
    visit("patience", self.patience, Unit("s"), Range{0.0, 1e4},
          "that the robot waits for what holds it up to go away, before it gives the target up");
    visit("back_off", self.back_off, Unit("m"), Range{0.0, 5.0},
          "the way that it came, from what the robot has touched, before anything else is planned");
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
  std::optional<Eigen::Vector2d> held_map;     // what only the map knows, if that held the robot up
  std::string reason;                          // why it was given up
  std::vector<slam::Pose2> poses_map;          // driven, as the robot took itself to be, to its last place
  slam::Pose2::Square covariance = slam::Pose2::Square::Zero();  // of the last, in its tangent space
  double length = 0.0;                                           // [m]
};

/// By the paper's controller to a goal, instead of along a path.
struct ApproachTask {
  slam::Pose2 T_map_goal;
  control::ApproachBehaviour behaviour = control::ApproachBehaviour::kController;
  control::ApproachOptions options;
};

/// What is to be driven.
struct DriveTask {
  const std::vector<slam::Pose2>& path_map;
  const std::optional<ApproachTask>& approach;
  std::span<const slam::Pose2> trail_map;          // driven before
  std::span<const Eigen::Vector2d> obstacles_map;  // that are known
  double margin = 0.08;                            // that the path keeps from them [m]
  std::size_t retraced = 0;  // poses at its start, the way back: there the map errs; it may be cut
};

/// Drives a path or an approach, gives way to what the safety scanners see, and waits for it to go away.
/// Where something holds the wheels or does not go away, the robot backs off by the way that it came.
/// `stop` is asked before each command.
DriveReport DrivePath(drivers::Robot& robot, Localizer localizer, const DriveTask& task,
                      const DriveOptions& options, const std::function<bool()>& stop);

}  // namespace ariadne::experiments
