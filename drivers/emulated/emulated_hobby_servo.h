#pragma once

#include <cstdint>
#include <vector>

#include "drivers/emulated/emulated_device.h"
#include "drivers/emulated/position_memory.h"
#include "drivers/hardware/hobby_servo/maestro.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

struct EmulatedHobbyServoOptions {
  int channel = 0;
  int baud = 9600;
  double pulse = 1500.0;
  double fastest = 3500.0;
  double lag = 0.03;
  double reply_delay = 0.0005;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("channel", self.channel, Unit(""), Range{0, 23}, "that the servo is on");
    visit("baud", self.baud, Unit("baud"), Range{300, 200000}, "of the controller");
    visit("pulse", self.pulse, Unit("us"), Range{500.0, 2500.0}, "of where the servo stands at first");
    visit("fastest", self.fastest, Unit("us/s"), Range{100.0, 1e5},
          "of the servo, whatever its pulse does: a sixth of a turn in 0.19 s");
    visit("lag", self.lag, Unit("s"), Range{0.0, 1.0}, "by which it follows its pulse");
    visit("reply_delay", self.reply_delay, Unit("s"), Range{0.0, 0.01}, "before a reply");
  }
};

/// A Pololu Maestro controller with one servo. Choices where its guide is silent: the profile goes on in
/// steps of 10 ms as the guide has it for the speed, and brakes by its acceleration; the first target
/// after power or after none is a jump of the pulse; other channels have no servo, and their position is
/// what they were told. Errors are bit 4 (protocol) for what is no command.
class EmulatedHobbyServo : public EmulatedDevice {
 public:
  explicit EmulatedHobbyServo(const EmulatedHobbyServoOptions& options = {});

  void Receive(ByteView bytes, int baud, double time) override;
  double NextTime() const override;
  std::vector<Sending> Advance(double time) override;
  void LosePower(double time, double seconds) override;

  /// Where the servo is, and the pulse that it gets, 0 for none [us].
  double position() const { return position_; }
  double pulse() const { return pulse_; }
  /// And where the servo was a moment before, within the last second [us].
  double PositionAt(double time) const { return memory_.At(time, position_); }

  /// The servo is held: it follows no pulse, and nobody is told.
  void SetStuck(bool stuck) { stuck_ = stuck; }

 private:
  void Move(double time);
  void StepPulse();
  void Execute(const hobby_servo::Request& request, double time);
  void Reply(std::uint16_t number, double time);
  void SwitchOn();

  EmulatedHobbyServoOptions options_;
  hobby_servo::RequestDecoder decoder_;
  double position_;  // [us]
  PositionMemory memory_;
  double pulse_ = 0.0;         // [us]
  double rate_ = 0.0;          // of the pulse [us/s]
  double target_ = 0.0;        // [us]
  double speed_ = 0.0;         // limit, 0 for none [us/s]
  double acceleration_ = 0.0;  // limit, 0 for none [us/s^2]
  std::uint16_t errors_ = 0;
  std::uint64_t bad_ = 0;  // requests so far
  bool stuck_ = false;
  double now_ = 0.0;
  double next_step_ = 0.0;  // of the pulse [s]
  double ready_at_ = 0.0;
  double sent_until_ = 0.0;
  std::vector<Sending> sendings_;
};

}  // namespace ariadne::drivers
