#include "control/indiveri.h"

#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

/// sin(x) / x, also at 0.
double Sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

/// c e, which stays finite at the goal.
double ScaledCurvature(const GoalBearing& bearing, const IndiveriOptions& options) {
  return std::sin(bearing.alpha) + options.h * bearing.theta * Sinc(bearing.alpha) +
         options.beta * bearing.alpha;
}

}  // namespace

void RequireGains(const IndiveriOptions& options) {
  CheckOptions(options, "law.");
  if (options.any_gains) return;
  if (!(options.h > 1.0)) Fail("law.h is {}, but the path only ends straight with more than 1", options.h);
  if (options.beta > 2.0 && options.beta < options.h + 1.0) return;
  Fail("law.beta is {}, but the path only ends straight with more than 2 and less than h + 1 = {}",
       options.beta, options.h + 1.0);
}

GoalBearing BearingOf(const slam::Pose2& T_goal_robot) {
  const double distance = T_goal_robot.translation.norm();
  if (distance == 0.0) return {0.0, 0.0, slam::WrapAngle(-T_goal_robot.angle)};
  const double theta = std::atan2(-T_goal_robot.translation.y(), -T_goal_robot.translation.x());
  return {distance, slam::WrapAngle(theta), slam::WrapAngle(theta - T_goal_robot.angle)};
}

double PathCurvature(const GoalBearing& bearing, const IndiveriOptions& options) {
  if (bearing.distance == 0.0) return 0.0;
  return ScaledCurvature(bearing, options) / bearing.distance;
}

DriveCommand SteerToGoal(const slam::Pose2& T_goal_robot, const IndiveriOptions& options) {
  const GoalBearing bearing = BearingOf(T_goal_robot);
  if (bearing.distance == 0.0) return {};
  return {options.gamma * bearing.distance, options.gamma * ScaledCurvature(bearing, options)};
}

}  // namespace ariadne::control
