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

/// How far the odometry trusts its wheels.
struct OdometryOptions {
  double wheel_noise = 0.003;
  double radius_uncertainty = 0.001;
  double track_uncertainty = 0.005;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
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
  WheelOdometry(const DriveGeometry& geometry, const OdometryOptions& options);

  /// The counters now; the first call says where counting starts. Call it often: between two calls the
  /// base is taken to move on one arc.
  const slam::Odometry& Update(const WheelTicks& ticks);

  /// T_odom_base with the covariance of xi in T_odom_base(true) = T_odom_base * Exp(xi).
  const slam::Odometry& odometry() const { return odometry_; }

 private:
  void Roll(const WheelPair& ways);

  DriveGeometry geometry_;
  OdometryOptions options_;
  std::optional<WheelTicks> last_;
  slam::Odometry odometry_;
  Eigen::Matrix3d slip_covariance_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d effect_ =
      Eigen::Matrix3d::Zero();  // d xi / d(relative error of left radius, right, track)
};

}  // namespace ariadne::control
