#include "control/simulate_approach.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ariadne::control {
namespace {

using slam::Pose2;

/// The unicycle in the frame of its goal, stepped from period to period.
class Approach {
 public:
  Approach(const Pose2& T_goal_robot, ApproachBehaviour behaviour, const ApproachOptions& options)
      : options_(options), behaviour_(behaviour), T_goal_robot_(T_goal_robot) {
    max_distance_ = T_goal_robot.translation.norm() + options.max_excursion;
  }

  /// What to do in the next period; none where the approach has ended.
  std::optional<DriveCommand> Next() {
    const ApproachStep step = StepApproach(T_goal_robot_, progress_, behaviour_, options_);
    progress_ = step.progress;
    if (step.finished) return {};
    if (result_.duration >= options_.max_time) return End(ApproachStatus::kTimeOut);
    if (progress_.phase != ApproachPhase::kFinalTurn && T_goal_robot_.translation.norm() > max_distance_)
      return End(ApproachStatus::kLeftBehind);
    return step.command;
  }

  void Drive(const DriveCommand& command) {
    const double way = command.forward * options_.period;
    const double turn = command.turning * options_.period;
    T_goal_robot_ = T_goal_robot_ * Pose2::Exp({way, 0.0, turn});
    result_.length += std::abs(way);
    result_.turned += std::abs(turn);
    result_.duration = ++periods_ * options_.period;
  }

  const Pose2& T_goal_robot() const { return T_goal_robot_; }
  const ApproachCostResult& result() const { return result_; }

 private:
  std::optional<DriveCommand> End(ApproachStatus status) {
    result_.status = status;
    return {};
  }

  const ApproachOptions& options_;
  ApproachBehaviour behaviour_;
  Pose2 T_goal_robot_;
  double max_distance_ = 0.0;  // [m]
  int periods_ = 0;
  ApproachProgress progress_;
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
                                const ApproachOptions& options, ApproachBehaviour behaviour) {
  RequireApproach(T_map_robot, T_map_goal, options);
  Approach approach(T_map_goal.Inverse() * T_map_robot, behaviour, options);
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
                                const ApproachOptions& options, ApproachBehaviour behaviour) {
  RequireApproach(T_map_robot, T_map_goal, options);
  Approach approach(T_map_goal.Inverse() * T_map_robot, behaviour, options);
  while (const std::optional<DriveCommand> command = approach.Next()) approach.Drive(*command);
  return approach.result();
}

}  // namespace ariadne::control
