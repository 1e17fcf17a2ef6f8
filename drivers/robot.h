#pragma once

#include <vector>

#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// What the base is told to do: forward speed and turning speed, held until the next command.
struct Velocity {
  double forward = 0.0;  // [m/s]
  double turning = 0.0;  // counterclockwise [rad/s]
};

/// What the robot knows about itself at a moment.
struct RobotState {
  double stamp = 0.0;  // [s]
  slam::Odometry odometry;
  Velocity velocity;     // as the wheels turn, not as commanded
  bool blocked = false;  // a bumper, a collision or an emergency stop holds the wheels
};

/// A 2D scanner that watches the floor plan while driving, in the base frame.
struct SafetySweep {
  slam::Pose3 T_base_laser;
  slam::ScannerModel scanner;
  slam::LaserSweep sweep;
};

/// The one seam between the algorithms and any robot: simulated, real, emulated or replayed. Time is the
/// robot's own; nothing else of the program looks at a clock. Each call throws an Error with a sentence
/// that says what to do when the robot cannot do it; the wheels stand then.
class Robot {
 public:
  virtual ~Robot() = default;

  /// Seconds since the robot was started.
  virtual double Now() const = 0;

  /// Where the 3D scanner sits on the base.
  virtual slam::Pose3 T_base_laser() const = 0;

  /// Takes a 3D scan, standing: stops the wheels first. Repeats it where the scene moved meanwhile
  /// (Sec. 3.4).
  virtual slam::Scan TakeScan() = 0;

  /// One sweep of the 3D scanner in horizontal mode (Sec. 5.3), now, also while driving.
  virtual slam::LaserSweep TakeSweep() = 0;

  /// What the safety scanners see now; none where the robot has none.
  virtual std::vector<SafetySweep> TakeSafetySweeps() = 0;

  virtual RobotState State() = 0;

  /// Sets the velocity that the base is to reach within its limits.
  virtual void Drive(const Velocity& velocity) = 0;

  /// Lets the robot go on until a time of its own clock [s].
  virtual void WaitUntil(double time) = 0;
};

}  // namespace ariadne::drivers
