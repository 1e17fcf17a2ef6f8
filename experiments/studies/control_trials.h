#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "control/pure_pursuit.h"
#include "control/simulate_approach.h"
#include "experiments/report/table.h"
#include "planning/path/plan_path.h"

namespace ariadne::experiments {

/// One drive from a pose to another.
struct ControlTrial {
  std::string controller;
  bool reached = false;                 // by its own account
  double distance = 0.0, angle = 0.0;   // of the end from the goal [m], [rad]
  double length = 0.0, straight = 0.0;  // of the path, and of the line to the goal [m]
  double duration = 0.0;                // [s]
  double curvature_far = 0.0;           // largest at 25 to 50 cm from the goal [1/m]
  double curvature_near = 0.0;          // largest at 2 to 5 cm from the goal [1/m]
  double turning_changes = 0.0;         // integral of |d omega| [rad/s]
  int violations = 0;                   // commands beyond a limit
};

/// A start around the goal (0, 0, 0): evenly within a disc, any heading.
slam::Pose2 DrawStart(std::uint64_t seed, double distance);

/// What came of a simulation.
ControlTrial JudgeTrial(const std::string& controller, const control::ApproachResult& result,
                        const control::DriveLimits& limits, double period);

/// Of each controller, in the order in which they come: how many reach the goal, within 1 cm and 0.5 deg,
/// and medians and 95 % quantiles.
Table ControlTable(const std::vector<ControlTrial>& trials);

Table ControlTrialTable(const std::vector<ControlTrial>& trials);

}  // namespace ariadne::experiments
