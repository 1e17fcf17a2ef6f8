#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/replay/call_bytes.h"
#include "drivers/replay/logged_robot.h"
#include "drivers/simulated/simulated_robot.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {

/// A room through which somebody walks, so that scans are repeated.
inline std::shared_ptr<const RayScene> SceneWithWalker() {
  World world = FurnishedRoom();
  Body walker = BoxBody("walker", {-0.15, -0.15, 0.0}, {0.15, 0.15, 1.8});
  walker.motion = {{0.5, 8.0}, {slam::ToPose3({0.0, {2.5, -2.5}}), slam::ToPose3({0.0, {2.5, 2.5}})}};
  world.bodies.push_back(walker);
  return std::make_shared<RayScene>(std::move(world));
}

/// Coarse, so that a test takes milliseconds.
inline SimulatedRobotOptions CoarseRobot() {
  SimulatedRobotOptions options;
  options.ais.slices = 64;
  options.ais.range_finder.mixed_pixels = false;
  options.safety.half_degree = false;
  options.safety.range_finder.mixed_pixels = false;
  options.base.command_timeout = 0.25;
  return options;
}

/// What a mission has seen, call by call, as bytes.
class Witness : public Robot {
 public:
  explicit Witness(Robot& robot) : robot_(robot) {}

  double Now() const override { return Seen(NowCall{robot_.Now()}).time; }
  slam::Pose3 T_base_laser() const override {
    return Seen(MountingCall{robot_.T_base_laser()}).T_base_laser;
  }
  slam::Scan TakeScan() override { return Seen(ScanCall{robot_.TakeScan()}).scan; }
  slam::LaserSweep TakeSweep() override { return Seen(SweepCall{robot_.TakeSweep()}).sweep; }
  std::vector<SafetySweep> TakeSafetySweeps() override {
    return Seen(SafetySweepsCall{robot_.TakeSafetySweeps()}).sweeps;
  }
  RobotState State() override { return Seen(StateCall{robot_.State()}).state; }
  void Drive(const Velocity& velocity) override { robot_.Drive(velocity); }
  void WaitUntil(double time) override { robot_.WaitUntil(time); }

  const std::vector<std::string>& seen() const { return seen_; }

 private:
  template <typename Call>
  Call Seen(Call call) const {
    seen_.push_back(EncodeCall(call));
    return call;
  }

  Robot& robot_;
  mutable std::vector<std::string> seen_;
};

/// Scans, and drives on the way that the answers say: what it does depends on all of them.
inline void RunSmallMission(Robot& robot, LoggedRobot* log = nullptr, double haste = 1.0) {
  const double reach = robot.T_base_laser().translation.x();
  for (int stop = 0; stop < 3; ++stop) {
    const slam::Scan scan = robot.TakeScan();
    const float ahead = scan.sweeps.front().ranges[90];
    const double speed = haste * (0.2 + 0.01 * (std::isfinite(ahead) ? ahead : 0.0) + 0.1 * reach);
    if (log != nullptr) log->Note("stop " + std::to_string(stop));
    const double end = robot.Now() + 1.0;
    while (robot.Now() < end) {
      const RobotState state = robot.State();
      const auto safety = robot.TakeSafetySweeps();
      const float right = safety.front().sweep.ranges[20];
      robot.Drive({speed, state.odometry.T_odom_base.angle + (right < 2.0F ? 0.3 : -0.1)});
      robot.WaitUntil(state.stamp + 0.1);
    }
    robot.TakeSweep();
    if (stop == 1) robot.WaitUntil(end + 1.0);  // until the base brakes by itself
  }
}

}  // namespace ariadne::drivers
