#pragma once

#include <cstdint>
#include <optional>

#include "control/differential_drive.h"
#include "slam/base/options.h"
#include "slam/scan/scan.h"

namespace ariadne::control {

/// The counters of the wheels' encoders; forward counts up. They run on through their largest value to
/// zero, and signed 32-bit counters are the same bits.
struct WheelTicks {
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};

/// How many ticks a counter made, forward or backward, provided that it made less than 2^31.
std::int32_t TicksSince(std::uint32_t before, std::uint32_t now);

/// What the odometry believes of its base, and how far it trusts it.
struct OdometryOptions {
  double wheel_radius = 0.1;
  double track = 0.5;
  int ticks_per_turn = 4000;
  double wheel_noise = 0.003;
  double radius_uncertainty = 0.001;
  double track_uncertainty = 0.005;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("wheel_radius", self.wheel_radius, Unit("m"), Range{0.005, 1.0},
          "open in the paper (2.1); wheels of 20 cm fit under a platform of 80 x 60 cm");
    visit("track", self.track, Unit("m"), Range{0.05, 3.0},
          "between the wheels' contact points; open in the paper, 50 cm of the 60 cm width");
    visit("ticks_per_turn", self.ticks_per_turn, Unit(""), Range{1, 1e7},
          "of a wheel; open in the paper, 1000 lines in quadrature are usual: 0.16 mm");
    visit("wheel_noise", self.wheel_noise, Unit("m per sqrt(m)"), Range{0.0, 1.0},
          "sigma of a wheel's way after 1 m, its variance grows with the way: slip, uneven floor");
    visit("radius_uncertainty", self.radius_uncertainty, Unit(""), Range{0.0, 0.2},
          "sigma of each wheel's radius, relative: what calibration leaves (UMBmark)");
    visit("track_uncertainty", self.track_uncertainty, Unit(""), Range{0.0, 0.2},
          "sigma of the track, relative: contact points wander on soft tyres");
  }
};

/// Dead reckoning from the wheels' encoders. Its covariance has two parts: slip, independent from step to
/// step, and the constant errors of radii and track, whose effects add up along the way. The quantization
/// of the ticks does not add up and is neglected.
class WheelOdometry {
 public:
  explicit WheelOdometry(const OdometryOptions& options);

  /// The counters now; the first call says where counting starts. Call it often: between two calls the
  /// base is taken to move on one arc.
  const slam::Odometry& Update(const WheelTicks& ticks);

  /// T_odom_base with the covariance of xi in T_odom_base(true) = T_odom_base * Exp(xi).
  const slam::Odometry& odometry() const { return odometry_; }

 private:
  void Roll(const WheelPair& ways);

  OdometryOptions options_;
  std::optional<WheelTicks> last_;
  slam::Odometry odometry_;
  Eigen::Matrix3d slip_covariance_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d effect_ =
      Eigen::Matrix3d::Zero();  // d xi / d(relative error of left radius, right, track)
};

}  // namespace ariadne::control
