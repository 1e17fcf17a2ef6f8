#include "drivers/safety/guarded_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <type_traits>
#include <utility>

#include "drivers/emergency_stopped.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

GuardOptions CheckedGuard(const GuardOptions& options) {
  CheckOptions(options, "guard.");
  return options;
}

bool IsZero(const Velocity& velocity) { return velocity.forward == 0.0 && velocity.turning == 0.0; }

}  // namespace

GuardedRobot::GuardedRobot(Robot& robot, EmergencyStop& stop, const GuardOptions& options)
    : robot_(robot), stop_(stop), options_(CheckedGuard(options)) {}

/// Whatever a call throws, the wheels stand when it leaves.
template <typename Call>
auto GuardedRobot::Guarded(const Call& call) {
  try {
    Check();
    return call();
  } catch (const std::exception& error) {
    StopAfterError(error.what());
    throw;
  }
}

void GuardedRobot::StopWheels(const std::string& reason) {
  stopped_because_ = reason;
  turning_ = false;
  robot_.Drive({});
}

void GuardedRobot::StopAfterError(const std::string& reason) noexcept {
  if (!turning_) return;
  try {
    StopWheels(reason);
  } catch (const std::exception& error) {
    turning_ = false;
    stop_.Press(fmt::format("the wheels may be turning, as they could not be stopped: {}", error.what()));
  }
}

bool GuardedRobot::IsBlind() const {
  return options_.sensor_timeout > 0.0 && robot_.Now() - newest_sweep_ > options_.sensor_timeout;
}

/// Of those who command the robot some look seldom; that a scanner lives is then asked for here.
void GuardedRobot::RefreshSensors() {
  if (options_.sensor_timeout == 0.0 || robot_.Now() - newest_sweep_ < 0.5 * options_.sensor_timeout)
    return;
  const std::vector<SafetySweep> sweeps = robot_.TakeSafetySweeps();
  for (const SafetySweep& sweep : sweeps) NoteSweep(sweep.sweep);
  if (sweeps.empty()) NoteSweep(robot_.TakeSweep());  // a robot without safety scanners
}

void GuardedRobot::NoteSweep(const slam::LaserSweep& sweep) {
  newest_sweep_ = std::max(newest_sweep_, sweep.stamp);
}

/// Stops the wheels where they turn and must not.
void GuardedRobot::Check() {
  if (!turning_) return;
  if (stop_.IsPressed()) return StopWheels(stop_.reason());
  if (robot_.Now() - commanded_ > options_.command_timeout)
    return StopWheels(fmt::format("no command came for {} s", options_.command_timeout));
  RefreshSensors();
  if (IsBlind()) StopWheels(fmt::format("no sweep came for {} s", options_.sensor_timeout));
}

slam::Scan GuardedRobot::TakeScan() {
  if (stop_.IsPressed()) {
    Check();
    throw EmergencyStopped(
        fmt::format("nothing is scanned: {}; release the emergency stop, or start again", stop_.reason()));
  }
  return Guarded([&] {
    slam::Scan scan = robot_.TakeScan();
    turning_ = false;  // a scan stops the wheels
    for (const slam::LaserSweep& sweep : scan.sweeps) NoteSweep(sweep);
    return scan;
  });
}

slam::LaserSweep GuardedRobot::TakeSweep() {
  return Guarded([&] {
    slam::LaserSweep sweep = robot_.TakeSweep();
    NoteSweep(sweep);
    return sweep;
  });
}

std::vector<SafetySweep> GuardedRobot::TakeSafetySweeps() {
  return Guarded([&] {
    std::vector<SafetySweep> sweeps = robot_.TakeSafetySweeps();
    for (const SafetySweep& sweep : sweeps) NoteSweep(sweep.sweep);
    return sweeps;
  });
}

RobotState GuardedRobot::State() {
  return Guarded([&] {
    RobotState state = robot_.State();
    state.blocked = state.blocked || stop_.IsPressed();
    return state;
  });
}

/// Zero speed is sent whatever else is wrong, and first.
void GuardedRobot::Drive(const Velocity& velocity) {
  if (IsZero(velocity)) return SendSpeed(velocity);
  if (stop_.IsPressed()) {
    Check();
    throw EmergencyStopped(fmt::format(
        "the robot does not drive: {}; release the emergency stop, or start again", stop_.reason()));
  }
  commanded_ = robot_.Now();
  Guarded([&] { RefreshSensors(); });
  if (IsBlind()) {
    Fail("the robot does not drive: no sweep came for {} s; see the scanner and its line",
         options_.sensor_timeout);
  }
  turning_ = true;  // also where the command fails half way
  SendSpeed(velocity);
}

void GuardedRobot::SendSpeed(const Velocity& velocity) {
  try {
    robot_.Drive(velocity);
    turning_ = !IsZero(velocity);
  } catch (const std::exception& error) {
    StopAfterError(error.what());
    throw;
  }
}

/// In steps, between which all is looked at; standing there is nothing to look at.
void GuardedRobot::WaitUntil(double time) {
  while (turning_ && robot_.Now() < time) {
    const double before = robot_.Now();
    Guarded([&] { robot_.WaitUntil(std::min(time, before + options_.check_period)); });
    if (robot_.Now() <= before) break;  // a robot whose time does not go on would be waited for for ever
  }
  Guarded([&] {
    if (robot_.Now() < time) robot_.WaitUntil(time);
  });
}

}  // namespace ariadne::drivers
