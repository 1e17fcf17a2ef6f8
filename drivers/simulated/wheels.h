#pragma once

#include "control/odometry.h"
#include "drivers/robot.h"
#include "slam/base/random.h"

namespace ariadne::drivers {

/// How the driven wheels differ from their drawing, and what the motors can do. Each source of error is off
/// at 0 and draws from a stream of its own, so that changing one leaves the draws of the others alone.
struct WheelsOptions {
  double left_radius_error = 0.0;
  double right_radius_error = 0.0;
  double track_error = 0.0;
  double radius_spread = 0.001;
  double track_spread = 0.005;
  double slip = 0.003;
  double max_speed = 0.8;
  double max_turning = 1.0;
  double acceleration = 0.5;
  double turning_acceleration = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("left_radius_error", self.left_radius_error, Unit(""), Range{-0.2, 0.2},
          "of the left wheel's radius, relative: unequal wheels drive a circle (UMBmark's E_d)");
    visit("right_radius_error", self.right_radius_error, Unit(""), Range{-0.2, 0.2}, "of the right one's");
    visit("track_error", self.track_error, Unit(""), Range{-0.2, 0.2},
          "of the track, relative: a wider one turns less (UMBmark's E_b)");
    visit("radius_spread", self.radius_spread, Unit(""), Range{0.0, 0.2},
          "sigma of a further error of each radius, drawn once: what calibration leaves");
    visit("track_spread", self.track_spread, Unit(""), Range{0.0, 0.2},
          "sigma of a further error of the track, drawn once: contact points of soft tyres");
    visit("slip", self.slip, Unit("m per sqrt(m)"), Range{0.0, 1.0},
          "sigma of a wheel's way over the ground after 1 m, its variance grows with the way");
    visit("max_speed", self.max_speed, Unit("m/s"), Range{0.001, 10.0}, "Sec. 2.1");
    visit("max_turning", self.max_turning, Unit("rad/s"), Range{0.001, 10.0},
          "open in the paper; 250 kg, and the corners then move at 0.5 m/s");
    visit("acceleration", self.acceleration, Unit("m/s^2"), Range{0.001, 100.0},
          "open in the paper; stops from full speed within 0.64 m");
    visit("turning_acceleration", self.turning_acceleration, Unit("rad/s^2"), Range{0.001, 100.0},
          "open in the paper; full turning within 1 s");
  }
};

/// What the wheels do in a short time, if nothing is in their way.
struct WheelStep {
  control::WheelPair encoded;  // way as the encoders count it [m]
  control::WheelPair rolled;   // way over the ground [m]
};

/// Two driven wheels with motors, encoders and ground contact.
class Wheels {
 public:
  Wheels(const control::DriveGeometry& drawing, const WheelsOptions& options, std::uint64_t seed);

  /// What to accelerate to. Beyond the limits both parts are reduced alike, so that the curve stays.
  void Command(const Velocity& target);

  /// As the encoders see it.
  const Velocity& velocity() const { return velocity_; }
  bool stands() const { return velocity_.forward == 0.0 && velocity_.turning == 0.0; }
  bool idle() const { return stands() && target_.forward == 0.0 && target_.turning == 0.0; }

  /// Accelerates for a time [s] and says what the wheels do meanwhile; draws the slip.
  WheelStep Accelerate(double duration);

  /// The same where other motors turn the wheels, by ways that their encoders would count [m].
  WheelStep Roll(const control::WheelPair& encoded);

  /// The encoders count a share of the step.
  void Turn(const WheelStep& step, double share);

  /// Over the ground with a share of the step: T_before_after.
  slam::Pose2 Motion(const WheelStep& step, double share) const;

  /// Stops at once, and stays.
  void Block();

  control::WheelTicks Ticks() const;

 private:
  double Slip(double way);

  control::DriveGeometry drawing_;
  WheelsOptions options_;
  RandomStream slip_;
  double left_scale_ = 1.0;  // true radius over the drawing's
  double right_scale_ = 1.0;
  double true_track_ = 0.0;  // [m]
  Velocity target_;
  Velocity velocity_;
  control::WheelPair encoded_;  // since the start [m]
};

}  // namespace ariadne::drivers
