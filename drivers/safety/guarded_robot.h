#pragma once

#include <limits>
#include <string>

#include "drivers/robot.h"
#include "drivers/safety/emergency_stop.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

struct GuardOptions {
  double command_timeout = 0.5;
  double sensor_timeout = 0.5;
  double check_period = 0.05;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("command_timeout", self.command_timeout, Unit("s"), Range{0.05, 60.0},
          "after the last command until the wheels are stopped; drives command every 0.1 s");
    visit("sensor_timeout", self.sensor_timeout, Unit("s"), Range{0.0, 60.0},
          "of the newest sweep, until the wheels are stopped: at 0.8 m/s the robot is 40 cm on its way; 0 "
          "for a robot without scanners that see while it drives");
    visit("check_period", self.check_period, Unit("s"), Range{0.005, 0.08},
          "at which waiting looks whether something is wrong: zero speed is sent within 100 ms");
  }
};

/// A robot whose wheels turn only while nothing is wrong. Three things are, and each sends zero speed
/// within 100 ms of the robot's own time, as far as the robot's calls return within that:
/// - the emergency stop is pressed: from then on only zero speed is accepted, and every other Drive and
///   every TakeScan throws EmergencyStopped with its reason, until it is released;
/// - no sweep (of any scanner) is newer than the sensor timeout while the wheels are to turn: before that,
///   half way, the robot is asked for one; every Drive throws until there is one;
/// - no command came within the command timeout: the next one is accepted.
/// A call that throws stops the wheels too, and presses the emergency stop where even that fails. A program
/// that hangs or dies calls nobody; against that the motor board has a timeout of its own.
class GuardedRobot : public Robot {
 public:
  /// Keeps references.
  GuardedRobot(Robot& robot, EmergencyStop& stop, const GuardOptions& options = {});

  double Now() const override { return robot_.Now(); }
  slam::Pose3 T_base_laser() const override { return robot_.T_base_laser(); }
  slam::Scan TakeScan() override;
  slam::LaserSweep TakeSweep() override;
  std::vector<SafetySweep> TakeSafetySweeps() override;
  /// Blocked also where the emergency stop holds the wheels.
  RobotState State() override;
  void Drive(const Velocity& velocity) override;
  void WaitUntil(double time) override;

  /// Why the wheels were stopped last; empty where they never were.
  const std::string& stopped_because() const { return stopped_because_; }

 private:
  template <typename Call>
  auto Guarded(const Call& call);
  void Check();
  void RefreshSensors();
  bool IsBlind() const;
  void SendSpeed(const Velocity& velocity);
  void StopWheels(const std::string& reason);
  void StopAfterError(const std::string& reason) noexcept;
  void NoteSweep(const slam::LaserSweep& sweep);

  Robot& robot_;
  EmergencyStop& stop_;
  GuardOptions options_;
  bool turning_ = false;                                            // the wheels were told to
  double commanded_ = 0.0;                                          // the last command [s]
  double newest_sweep_ = -std::numeric_limits<double>::infinity();  // its stamp [s]
  std::string stopped_because_;
};

}  // namespace ariadne::drivers
