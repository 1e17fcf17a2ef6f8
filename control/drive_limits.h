#pragma once

#include "slam/base/options.h"

namespace ariadne::control {

/// What the base is told to do: forward speed and turning speed, held until the next command.
struct DriveCommand {
  double forward = 0.0;  // [m/s]
  double turning = 0.0;  // counterclockwise [rad/s]
};

/// What the motors can do. The defaults are those of the simulated base.
struct DriveLimits {
  double max_speed = 0.8;
  double max_turning = 1.0;
  double max_wheel_speed = 1.05;
  double track = 0.5;
  double acceleration = 0.5;
  double turning_acceleration = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_speed", self.max_speed, Unit("m/s"), Range{0.001, 10.0}, "u_max; Sec. 2.1");
    visit("max_turning", self.max_turning, Unit("rad/s"), Range{0.001, 100.0},
          "open in the paper; 250 kg, and the corners then move at 0.5 m/s");
    visit("max_wheel_speed", self.max_wheel_speed, Unit("m/s"), Range{0.001, 100.0},
          "of a rim; the default is what the other two need at once");
    visit("track", self.track, Unit("m"), Range{0.05, 3.0}, "between the wheels' contact points");
    visit("acceleration", self.acceleration, Unit("m/s^2"), Range{0.001, 1e6},
          "open in the paper; also of braking. 1e6: none");
    visit("turning_acceleration", self.turning_acceleration, Unit("rad/s^2"), Range{0.001, 1e6},
          "open in the paper; 1e6: none");
  }
};

/// The fastest command within the limits of speed that drives the same curve: both parts are reduced alike
/// (the sat of Sec. 5.1; the ratio of its speeds is the path's curvature).
DriveCommand Saturated(const DriveCommand& wanted, const DriveLimits& limits);

/// The command for the next `period` [s] after one that was carried out: saturated, and no faster or slower
/// than the motors can follow. Where braking or accelerating leaves a choice, the curve stays the wanted
/// one; where it leaves none, each part comes as near to it as it can.
DriveCommand Limited(const DriveCommand& wanted, const DriveCommand& before, double period,
                     const DriveLimits& limits);

}  // namespace ariadne::control
