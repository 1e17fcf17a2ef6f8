#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "drivers/emulated/robot/emulated_lines.h"
#include "drivers/hardware/robot/hardware_robot.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {

/// An emulated robot in a world, and the driver that talks to it, in virtual time.
struct RobotBenchOptions {
  SimulatedBaseOptions base;
  AisScannerOptions ais;
  EmulatedRobotOptions emulated;
  HardwareRobotOptions hardware;
  std::uint64_t seed = 1;
};

/// Scans of 128 slices, and nothing errs but by the units of the devices.
inline RobotBenchOptions Exact() {
  RobotBenchOptions options;
  options.hardware.scanner.resolution = 1.0;
  options.hardware.tilt.slices = 128;
  options.base.wheels.radius_spread = options.base.wheels.track_spread = options.base.wheels.slip = 0.0;
  options.ais.range_finder = WithoutErrors(options.ais.range_finder);
  return options;
}

struct RobotBench {
  explicit RobotBench(World world, const RobotBenchOptions& options = Exact())
      : scene(std::make_shared<RayScene>(std::move(world))),
        device(scene, options.base, options.ais, options.emulated, options.seed) {
    EmulatedLines made = LinesTo(device);
    scanner = made.scanner.get();
    servo = made.servo.get();
    motors = made.motors.get();
    robot = std::make_unique<HardwareRobot>(
        RobotLines{std::move(made.scanner), std::move(made.servo), std::move(made.motors)},
        options.hardware);
  }

  /// In pieces, as a mission does: the base stops where commands fail to come.
  void DriveFor(const Velocity& velocity, double seconds) const {
    for (const double end = robot->Now() + seconds; robot->Now() < end;) {
      robot->Drive(velocity);
      robot->WaitUntil(std::min(end, robot->Now() + 0.05));
    }
  }
  void Halt() const {
    while (robot->State().velocity.forward != 0.0 || robot->State().velocity.turning != 0.0)
      DriveFor({}, 0.05);
  }

  /// Remembers what the devices did in each sweep of the scanner from now on.
  void Watch() {
    device.SetCatchUp([this](double until) {
      servo->CatchUp(until);
      motors->CatchUp(until);
      const double begin = until - kTurn;
      truths.push_back({begin, device.PitchAt(begin)});
    });
  }

  static constexpr double kTurn = 1.0 / 75.0;  // of the scanner's mirror [s]
  struct Truth {
    double stamp;  // of the sweep's beginning, by the lines' clock [s]
    double pitch;  // then [rad]
  };
  std::vector<Truth> truths;

  /// Of the sweep that began nearest to a time of the lines' clock [s].
  Truth TruthAt(double time) const {
    return *std::ranges::min_element(truths, {},
                                     [time](const Truth& truth) { return std::abs(truth.stamp - time); });
  }

  std::shared_ptr<const RayScene> scene;
  EmulatedRobot device;
  EmulatedLine* scanner = nullptr;
  EmulatedLine* servo = nullptr;
  EmulatedLine* motors = nullptr;
  std::unique_ptr<HardwareRobot> robot;
};

}  // namespace ariadne::drivers
