#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/robot.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

/// Answers what a test has put there, and remembers what it was told.
class ScriptedRobot : public Robot {
 public:
  double Now() const override { return state.stamp; }
  slam::Pose3 T_base_laser() const override { return {}; }
  slam::Scan TakeScan() override {
    if (broken) Fail("the scanner does not answer");
    slam::Scan scan;
    scan.odometry = state.odometry;
    scan.sweeps = {TakeSweep(), TakeSweep()};
    return scan;
  }
  slam::LaserSweep TakeSweep() override { return {state.stamp, 0.0, 0.0, {1.0F}, {}}; }
  std::vector<SafetySweep> TakeSafetySweeps() override { return {{{}, {}, TakeSweep()}}; }
  RobotState State() override { return state; }
  void Drive(const Velocity& velocity) override { told.push_back(velocity.forward); }
  void WaitUntil(double time) override { state.stamp = time; }

  RobotState state;
  bool broken = false;
  std::vector<double> told;  // forward speeds
};

}  // namespace ariadne::drivers
