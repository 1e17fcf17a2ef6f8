#include "drivers/hardware/robot/tilt_mount.h"

#include <fmt/format.h>

#include <utility>

namespace ariadne::drivers {
namespace {

/// Measures where it is.
class DynamixelMount : public TiltMount {
 public:
  DynamixelMount(std::unique_ptr<ByteStream> line, const HardwareRobotOptions& options)
      : servo_(std::move(line), options.servo), tolerance_(options.tilt.tolerance) {}

  void Connect() override { servo_.Connect(); }
  void Hold() override { servo_.SetTorque(true); }
  void SetProfile(double velocity, double acceleration) override {
    servo_.SetProfile(velocity, acceleration);
  }
  void MoveTo(double angle) override { servo_.MoveTo(angle); }
  MountState State() override {
    const dynamixel::ServoState state = servo_.State();
    return {state.time, state.angle};
  }
  double settling() const override { return 0.0; }
  double lag() const override { return 0.0; }
  [[noreturn]] void FailStanding(double angle) override {
    servo_.WaitFor(angle, tolerance_, 0.0);  // says what is wrong
    Fail("the mount came to {:.3f} rad too late; see hardware.tilt.max_time", angle);
  }
  std::string Describe() override {
    return fmt::format("model {}, at {:.3f} rad", servo_.model(), servo_.State().angle);
  }

 private:
  dynamixel::Servo servo_;
  double tolerance_;
};

/// Is where its pulse was a lag ago.
class HobbyMount : public TiltMount {
 public:
  HobbyMount(std::unique_ptr<ByteStream> line, const HardwareRobotOptions& options)
      : servo_(std::move(line), options.hobby_servo) {}

  void Connect() override { servo_.Connect(); }
  void Hold() override {}  // with the first motion
  void SetProfile(double velocity, double acceleration) override {
    servo_.SetProfile(velocity, acceleration);
  }
  void MoveTo(double angle) override { servo_.MoveTo(angle); }
  MountState State() override {
    const hobby_servo::CommandedState state = servo_.State();
    return {state.time + lag(), state.angle};
  }
  double settling() const override { return servo_.options().settling; }
  double lag() const override { return servo_.options().lag; }
  [[noreturn]] void FailStanding(double angle) override {
    servo_.WaitFor(angle, 0.0);  // says what is wrong
    Fail("the mount came to {:.3f} rad too late; see hardware.tilt.max_time", angle);
  }
  std::string Describe() override {
    return fmt::format("a controller on channel {}; where its servo is, nobody measures",
                       servo_.options().channel);
  }

 private:
  hobby_servo::HobbyServo servo_;
};

}  // namespace

std::unique_ptr<TiltMount> MakeTiltMount(std::unique_ptr<ByteStream> line,
                                         const HardwareRobotOptions& options) {
  if (options.servo_kind == ServoKind::kHobby)
    return std::make_unique<HobbyMount>(std::move(line), options);
  return std::make_unique<DynamixelMount>(std::move(line), options);
}

MountRange MountRangeOf(const HardwareRobotOptions& options) {
  if (options.servo_kind == ServoKind::kHobby)
    return {options.hobby_servo.min_angle, options.hobby_servo.max_angle};
  return {options.servo.min_angle, options.servo.max_angle};
}

}  // namespace ariadne::drivers
