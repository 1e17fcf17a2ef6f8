#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "drivers/emulated/emulated_lms200.h"
#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/simulated/ais_scanner_options.h"
#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/simulated_base.h"

namespace ariadne::drivers {

struct EmulatedRobotOptions {
  EmulatedLms200Options scanner;
  EmulatedServoOptions servo;
  double level = 180.0;
  EmulatedMotorsOptions motors;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scanner", self.scanner, "the LMS-200");
    visit("servo", self.servo, "that tilts it");
    visit("level", self.level, Unit("deg"), Range{0.0, 360.0},
          "position of the servo where the scanner is level");
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
  EmulatedMotors& motors() { return motors_; }

  /// The truth.
  const SimulatedBase& base() const { return base_; }

  /// A wheel slips on something: the ground sees so much less of its way; 0 left, 1 right.
  void SetSlip(int wheel, double share) { slip_[static_cast<std::size_t>(wheel)] = share; }

 private:
  slam::LaserSweep Measure(double stamp, const slam::ScannerModel& scanner, std::size_t beams);
  double Roll(const std::array<double, 2>& pulses, double time);
  double PitchAt(double time) const;

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
  EmulatedMotors motors_;
};

}  // namespace ariadne::drivers
