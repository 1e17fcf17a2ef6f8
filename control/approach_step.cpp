#include "control/approach_step.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "control/turn_in_place.h"
#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr double kSteadyDistance = 0.1;  // nearer to the goal, errors of its bearing count no more [m]

/// None where it has turned, and stands.
std::optional<DriveCommand> TurnTo(double rest, const DriveCommand& before,
                                   const ApproachOptions& options) {
  const double tolerance = slam::RadFromDeg(options.goal_angle);
  if (HasTurned(rest, tolerance, before, options.period, options.limits)) return {};
  return TurnInPlace(rest, before, options.period, options.limits);
}

/// Towards the goal's place, which is ahead, so that the robot comes to stand there.
DriveCommand StraightToGoal(const Eigen::Vector2d& p_robot_goal, const ApproachOptions& options) {
  const double speed = BrakingSpeed(p_robot_goal.x(), options.limits.acceleration, options.period);
  const double distance = std::max(p_robot_goal.norm(), kSteadyDistance);
  return {speed, speed * 2.0 * p_robot_goal.y() / (distance * distance)};
}

/// None where driving has ended.
std::optional<DriveCommand> Drive(const Pose2& T_goal_robot, const DriveCommand& before,
                                  ApproachBehaviour behaviour, const ApproachOptions& options) {
  DriveCommand wanted;
  if (behaviour == ApproachBehaviour::kTurnStraightTurn) {
    const Eigen::Vector2d p_robot_goal = T_goal_robot.Inverse().translation;
    if (p_robot_goal.x() <= 0.5 * options.goal_distance) return {};
    wanted = StraightToGoal(p_robot_goal, options);
  } else {
    if (T_goal_robot.translation.norm() <= options.goal_distance) return {};
    wanted = SteerToGoal(T_goal_robot, options.law);
  }
  return Limited(wanted, before, options.period, options.limits);
}

}  // namespace

ApproachStep StepApproach(const Pose2& T_goal_robot, const ApproachProgress& progress,
                          ApproachBehaviour behaviour, const ApproachOptions& options) {
  const DriveCommand& before = progress.command;
  ApproachPhase phase = progress.phase;
  std::optional<DriveCommand> command;
  if (phase == ApproachPhase::kStart) {
    if (T_goal_robot.translation.norm() <= options.goal_distance) {
      phase = ApproachPhase::kFinalTurn;
    } else {
      if (behaviour != ApproachBehaviour::kController)
        command = TurnTo(BearingOf(T_goal_robot).alpha, before, options);
      if (!command) phase = ApproachPhase::kDrive;
    }
  }
  if (phase == ApproachPhase::kDrive) {
    command = Drive(T_goal_robot, before, behaviour, options);
    if (!command) phase = ApproachPhase::kFinalTurn;
  }
  if (phase == ApproachPhase::kFinalTurn)
    command = TurnTo(options.final_turn ? -T_goal_robot.angle : 0.0, before, options);
  const DriveCommand next = command.value_or(DriveCommand{});
  return {next, {phase, next}, !command};
}

}  // namespace ariadne::control
