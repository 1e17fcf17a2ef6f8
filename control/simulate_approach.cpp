#include "control/simulate_approach.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "control/turn_in_place.h"
#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

/// The unicycle in the frame of its goal, stepped from period to period.
class Approach {
 public:
  Approach(const Pose2& T_goal_robot, const ApproachOptions& options)
      : options_(options), T_goal_robot_(T_goal_robot) {
    max_distance_ = T_goal_robot.translation.norm() + options.max_excursion;
  }

  /// What to do in the next period; none where the approach has ended.
  std::optional<DriveCommand> Next() {
    if (result_.status != ApproachStatus::kReached) return {};
    const double distance = T_goal_robot_.translation.norm();
    if (distance <= options_.goal_distance) turning_ = true;
    if (turning_) return NextTurn();
    if (result_.duration >= options_.max_time) return End(ApproachStatus::kTimeOut);
    if (distance > max_distance_) return End(ApproachStatus::kLeftBehind);
    return Limited(SteerToGoal(T_goal_robot_, options_.law), before_, options_.period, options_.limits);
  }

  void Drive(const DriveCommand& command) {
    const double way = command.forward * options_.period;
    const double turn = command.turning * options_.period;
    T_goal_robot_ = T_goal_robot_ * Pose2::Exp({way, 0.0, turn});
    result_.length += std::abs(way);
    result_.turned += std::abs(turn);
    result_.duration = ++periods_ * options_.period;
    before_ = command;
  }

  const Pose2& T_goal_robot() const { return T_goal_robot_; }
  const ApproachCostResult& result() const { return result_; }

 private:
  std::optional<DriveCommand> End(ApproachStatus status) {
    result_.status = status;
    return {};
  }

  /// In place, once the wheels have stopped.
  std::optional<DriveCommand> NextTurn() {
    const double rest = options_.final_turn ? -T_goal_robot_.angle : 0.0;
    const double tolerance = slam::RadFromDeg(options_.goal_angle);
    if (HasTurned(rest, tolerance, before_, options_.period, options_.limits)) return {};
    if (result_.duration >= options_.max_time) return End(ApproachStatus::kTimeOut);
    return TurnInPlace(rest, before_, options_.period, options_.limits);
  }

  const ApproachOptions& options_;
  Pose2 T_goal_robot_;
  double max_distance_ = 0.0;  // [m]
  bool turning_ = false;
  int periods_ = 0;
  DriveCommand before_;
  ApproachCostResult result_;
};

void RequireApproach(const Pose2& T_map_robot, const Pose2& T_map_goal, const ApproachOptions& options) {
  CheckOptions(options, "approach.");
  RequireGains(options.law);
  for (const Pose2* pose : {&T_map_robot, &T_map_goal}) {
    if (std::isfinite(pose->angle) && pose->translation.allFinite()) continue;
    Fail("an approach cannot lead from ({}, {}, {} rad) to ({}, {}, {} rad)", T_map_robot.translation.x(),
         T_map_robot.translation.y(), T_map_robot.angle, T_map_goal.translation.x(),
         T_map_goal.translation.y(), T_map_goal.angle);
  }
}

}  // namespace

ApproachResult SimulateApproach(const Pose2& T_map_robot, const Pose2& T_map_goal,
                                const ApproachOptions& options) {
  RequireApproach(T_map_robot, T_map_goal, options);
  Approach approach(T_map_goal.Inverse() * T_map_robot, options);
  ApproachResult result;
  for (;;) {
    const std::optional<DriveCommand> command = approach.Next();
    result.samples.push_back({approach.result().duration, T_map_goal * approach.T_goal_robot(),
                              command.value_or(DriveCommand{})});
    if (!command) break;
    approach.Drive(*command);
  }
  result.status = approach.result().status;
  result.length = approach.result().length;
  result.duration = approach.result().duration;
  result.turned = approach.result().turned;
  return result;
}

ApproachCostResult ApproachCost(const Pose2& T_map_robot, const Pose2& T_map_goal,
                                const ApproachOptions& options) {
  RequireApproach(T_map_robot, T_map_goal, options);
  Approach approach(T_map_goal.Inverse() * T_map_robot, options);
  while (const std::optional<DriveCommand> command = approach.Next()) approach.Drive(*command);
  return approach.result();
}

}  // namespace ariadne::control
