#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "drivers/emulated/emulated_hobby_servo.h"
#include "drivers/emulated/emulated_lms200.h"
#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/hardware/servo_kind.h"
#include "drivers/simulated/ais_scanner_options.h"
#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/simulated_base.h"

namespace ariadne::drivers {

struct EmulatedRobotOptions {
  EmulatedLms200Options scanner;
  ServoKind servo_kind = ServoKind::kDynamixel;
  EmulatedServoOptions servo;
  double level = 180.0;
  EmulatedHobbyServoOptions hobby_servo;
  double level_pulse = 1500.0;
  double pulse_per_radian = 636.62;
  EmulatedMotorsOptions motors;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scanner", self.scanner, "the LMS-200");
    visit("servo_kind", self.servo_kind,
          "what tilts it; of `explore` with robot=emulated it is hardware.servo_kind");
    visit("servo", self.servo, "the Dynamixel");
    visit("level", self.level, Unit("deg"), Range{0.0, 360.0},
          "position of the Dynamixel where the scanner is level");
    visit("hobby_servo", self.hobby_servo, "the hobby servo and its controller");
    visit("level_pulse", self.level_pulse, Unit("us"), Range{500.0, 2500.0},
          "where the hobby servo holds the scanner level");
    visit("pulse_per_radian", self.pulse_per_radian, Unit("us"), Range{50.0, 3000.0},
          "of the hobby servo, truly");
    visit("motors", self.motors, "of the wheels, left and right");
  }
};

/// The devices of a robot, coupled to one simulated world: the motors move a simulated base, whose wheels
/// err and which collides; the servo tilts a simulated range finder, whose ranges the scanner sends. What a
/// device does at a time depends on where the others are then, so whoever lets the scanner live must let
/// the other two live up to the end of its sweep: that is `catch_up`.
class EmulatedRobot {
 public:
  /// Stands at the world's start. Keeps a reference to the scene's world.
  EmulatedRobot(std::shared_ptr<const RayScene> scene, const SimulatedBaseOptions& base,
                const AisScannerOptions& ais, const EmulatedRobotOptions& options, std::uint64_t seed);
  EmulatedRobot(const EmulatedRobot&) = delete;
  EmulatedRobot& operator=(const EmulatedRobot&) = delete;

  /// Called with the end of each sweep [s] before it is measured.
  void SetCatchUp(std::function<void(double time)> catch_up) { catch_up_ = std::move(catch_up); }

  EmulatedLms200& scanner() { return scanner_; }
  EmulatedServo& servo() { return servo_; }
  /// What tilts the scanner, of the kind of the options.
  EmulatedDevice& mount();
  /// Something holds the mount.
  void SetStuck(bool stuck);
  EmulatedMotors& motors() { return motors_; }

  /// The truth.
  const SimulatedBase& base() const { return base_; }
  double PitchAt(double time) const;  // up to a second ago [rad]

  /// A wheel slips on something: the ground sees so much less of its way; 0 left, 1 right.
  void SetSlip(int wheel, double share) { slip_[static_cast<std::size_t>(wheel)] = share; }

 private:
  slam::LaserSweep Measure(double stamp, const slam::ScannerModel& scanner, std::size_t beams);
  double Roll(const std::array<double, 2>& pulses, double time);

  std::shared_ptr<const RayScene> scene_;
  control::DriveGeometry drive_;
  AisScannerOptions ais_;
  EmulatedRobotOptions options_;
  std::uint64_t seed_;
  std::function<void(double)> catch_up_;
  std::array<double, 2> slip_{};
  SimulatedBase base_;
  std::uint64_t sweeps_ = 0;  // names the streams of noise
  EmulatedLms200 scanner_;
  EmulatedServo servo_;
  EmulatedHobbyServo hobby_servo_;
  EmulatedMotors motors_;
};

}  // namespace ariadne::drivers
