#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/hobby_servo/maestro.h"
#include "slam/base/options.h"

namespace ariadne::drivers::hobby_servo {

struct HobbyServoOptions {
  int channel = 0;
  int baud = 9600;
  double zero = 1500.0;
  double per_radian = 636.62;
  bool reversed = false;
  double min_pulse = 600.0;
  double max_pulse = 2400.0;
  double min_angle = -1.2;
  double max_angle = 1.2;
  double settling = 0.3;
  double lag = 0.03;
  double reply_time = 0.03;
  double recovery_time = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("channel", self.channel, Unit(""), Range{0, 23}, "of the controller");
    visit("baud", self.baud, Unit("baud"), Range{300, 200000},
          "9600 from the factory; over USB it is open");
    visit("zero", self.zero, Unit("us"), Range{500.0, 2500.0}, "pulse where the angle is 0");
    visit("per_radian", self.per_radian, Unit("us"), Range{50.0, 3000.0},
          "of pulse; 1 ms is a quarter turn as a rule, servos differ by some percent: measure it");
    visit("reversed", self.reversed, "whether longer pulses are smaller angles");
    visit("min_pulse", self.min_pulse, Unit("us"), Range{400.0, 2500.0}, "that the servo bears");
    visit("max_pulse", self.max_pulse, Unit("us"), Range{400.0, 2800.0}, "that the servo bears");
    visit("min_angle", self.min_angle, Unit("rad"), Range{-3.14, 3.14}, "that the mount bears");
    visit("max_angle", self.max_angle, Unit("rad"), Range{-3.14, 3.14}, "that the mount bears");
    visit("settling", self.settling, Unit("s"), Range{0.0, 10.0},
          "after the pulse has arrived until the servo surely has: nobody measures it");
    visit(
        "lag", self.lag, Unit("s"), Range{0.0, 1.0},
        "by which it follows its pulse while it moves evenly; what is wrong of it turns scans in pitch, as "
        "hardware.mount.pitch does");
    visit("reply_time", self.reply_time, Unit("s"), Range{0.001, 1.0},
          "to the end of a reply, beyond what the line needs; adapters keep bytes for up to 16 ms");
    visit("recovery_time", self.recovery_time, Unit("s"), Range{0.0, 60.0},
          "for which a silent controller is asked again");
  }
};

/// Where the controller sends a servo at a moment; where the servo is, it does not know.
struct CommandedState {
  double time = 0.0;   // between request and reply [s]
  double angle = 0.0;  // [rad]
};

/// A hobby servo on a Pololu Maestro controller: open loop. Angles are what is commanded, and the servo
/// follows by a lag that nobody measures, so scans tilted by one are calibrated, or taken in steps. Each
/// call throws an Error with a sentence where the controller does not answer or reports a fault. Replies
/// have no checksum: one that is no position between where the servo was and where it is sent is not
/// believed, and asked for again.
class HobbyServo {
 public:
  HobbyServo(std::unique_ptr<ByteStream> line, const HobbyServoOptions& options);

  /// Finds the controller. The servo does not move, and gets no pulses before the first MoveTo.
  void Connect();

  /// No pulses: the servo is limp.
  void Release();

  /// Limits of the motions that follow [rad/s, rad/s^2].
  void SetProfile(double velocity, double acceleration);

  /// Begins a motion; does not wait. The first one after Connect or Release is as fast as the servo is,
  /// since nobody knows where it begins. Error beyond the limits of the mount.
  void MoveTo(double angle);

  CommandedState State();

  /// Waits until the pulse of `angle` is sent, and for the settling time. Error if it is not after
  /// `seconds`.
  void WaitFor(double angle, double seconds);

  std::uint64_t repeated() const { return repeated_; }
  const HobbyServoOptions& options() const { return options_; }

 private:
  std::uint16_t Ask(Code code);
  int PulseNumber(double angle) const;
  double AngleOf(int number) const;
  void FailIfFaulty();
  bool IsOnTheWay(int number) const;

  std::unique_ptr<ByteStream> line_;
  HobbyServoOptions options_;
  int from_ = 0;    // where the motion began, 0 for nowhere [0.25 us]
  int target_ = 0;  // 0 for no pulses [0.25 us]
  std::uint64_t repeated_ = 0;
};

}  // namespace ariadne::drivers::hobby_servo
