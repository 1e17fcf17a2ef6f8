#pragma once

#include <memory>
#include <string>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/robot/hardware_robot_options.h"

namespace ariadne::drivers {

/// Where the mount was, by who turns it.
struct MountState {
  double time = 0.0;   // of the line [s]
  double angle = 0.0;  // [rad]
};

/// What turns the scanner: a servo that measures where it is, or one that is only known to follow. Each
/// call throws an Error with a sentence where it does not answer or reports a fault.
class TiltMount {
 public:
  virtual ~TiltMount() = default;

  /// Finds it. It does not move.
  virtual void Connect() = 0;

  /// Lets it hold its place.
  virtual void Hold() = 0;

  /// Limits of the motions that follow [rad/s, rad/s^2].
  virtual void SetProfile(double velocity, double acceleration) = 0;

  /// Begins a motion; does not wait.
  virtual void MoveTo(double angle) = 0;

  virtual MountState State() = 0;

  /// After State has it at its place until it surely is [s].
  virtual double settling() const = 0;

  /// By how much later than it is told it moves evenly [s].
  virtual double lag() const = 0;

  /// Throws the Error that it does not get there.
  [[noreturn]] virtual void FailStanding(double angle) = 0;

  /// For people, who it is and where.
  virtual std::string Describe() = 0;
};

/// The one that the options name.
std::unique_ptr<TiltMount> MakeTiltMount(std::unique_ptr<ByteStream> line,
                                         const HardwareRobotOptions& options);

/// The angles that it bears.
struct MountRange {
  double min = 0.0;
  double max = 0.0;
};
MountRange MountRangeOf(const HardwareRobotOptions& options);

}  // namespace ariadne::drivers
