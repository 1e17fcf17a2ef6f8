#pragma once

#include "control/drive_limits.h"
#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// The gains of the control law of Sec. 5.1 (Indiveri 1999), as in Fig. 9.
struct IndiveriOptions {
  double gamma = 1.0;
  double h = 2.0;
  double beta = 2.9;
  bool any_gains = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("gamma", self.gamma, Unit("1/s"), Range{1e-3, 100.0}, "speed per distance from the goal, Fig. 9");
    visit("h", self.h, Unit(""), Range{1e-3, 100.0}, "weight of the bearing's error, Fig. 9; above 1");
    visit("beta", self.beta, Unit(""), Range{1e-3, 100.0},
          "how fast the heading turns to the goal, Fig. 9; between 2 and h + 1");
    visit("any_gains", self.any_gains,
          "also those that are stable, but reach the goal on ever narrower curves; to show it");
  }
};

/// Error unless h > 1 and 2 < beta < h + 1, with which the path ends straight: its curvature goes to zero.
/// Stable are all positive gains.
void RequireGains(const IndiveriOptions& options);

/// Where the goal is, seen from the robot, and the robot from the goal.
struct GoalBearing {
  double distance = 0.0;  // e [m]
  double theta = 0.0;     // direction from robot to goal, in the goal's frame [rad], (-pi, pi]
  double alpha = 0.0;     // the same, in the robot's frame [rad], (-pi, pi]
};

GoalBearing BearingOf(const slam::Pose2& T_goal_robot);

/// The curvature c of the path [1/m]: sin(alpha) / e + h theta / e sin(alpha) / alpha + beta alpha / e.
/// Without bound towards the goal, unless alpha and theta are zero; 0 at the goal itself.
double PathCurvature(const GoalBearing& bearing, const IndiveriOptions& options);

/// u = gamma e and omega = u c, before any limits: always forward, time-invariant, and such that
/// V = (alpha^2 + h theta^2) / 2 never grows. Angles are wrapped, so that the goal is approached from the
/// nearer side; where one passes pi, V stays as it is.
DriveCommand SteerToGoal(const slam::Pose2& T_goal_robot, const IndiveriOptions& options);

}  // namespace ariadne::control
