#include "control/odometry.h"

#include <cmath>

namespace ariadne::control {

std::int32_t TicksSince(std::uint32_t before, std::uint32_t now) {
  return static_cast<std::int32_t>(now - before);  // both conversions are modulo 2^32 in C++20
}

WheelOdometry::WheelOdometry(const DriveGeometry& geometry, const OdometryOptions& options)
    : geometry_(geometry), options_(options) {
  CheckOptions(geometry, "drive.");
  CheckOptions(options, "odometry.");
}

const slam::Odometry& WheelOdometry::Update(const WheelTicks& ticks) {
  if (last_) {
    Roll(geometry_.WaysOf(TicksSince(last_->left, ticks.left), TicksSince(last_->right, ticks.right)));
  }
  last_ = ticks;
  return odometry_;
}

void WheelOdometry::Roll(const WheelPair& ways) {
  if (ways.left == 0.0 && ways.right == 0.0) return;
  const slam::Pose2 motion = RollArc(ways, geometry_.track);
  const Eigen::Matrix<double, 3, 2> J = RollArcJacobian(ways, geometry_.track);
  odometry_.T_odom_base = odometry_.T_odom_base * motion;

  // T Exp(xi) M Exp(J d) = T M Exp(Ad_{M^-1} xi) Exp(J d), to first order xi' = Ad_{M^-1} xi + J d.
  const Eigen::Matrix3d carry = motion.Inverse().Adjoint();
  const double variance_per_meter = options_.wheel_noise * options_.wheel_noise;
  const Eigen::Vector2d variance =
      variance_per_meter * Eigen::Vector2d(std::abs(ways.left), std::abs(ways.right));
  slip_covariance_ =
      carry * slip_covariance_ * carry.transpose() + J * variance.asDiagonal() * J.transpose();

  // A wider track, by the share e, turns by a / (1 + e) only: as if both wheels erred by -e (way - mean).
  const double half_difference = 0.5 * (ways.right - ways.left);
  Eigen::Matrix<double, 2, 3> ways_of_errors;
  ways_of_errors << ways.left, 0.0, half_difference, 0.0, ways.right, -half_difference;
  effect_ = carry * effect_ + J * ways_of_errors;
  const double radius_variance = options_.radius_uncertainty * options_.radius_uncertainty;
  const double track_variance = options_.track_uncertainty * options_.track_uncertainty;
  const Eigen::Vector3d errors(radius_variance, radius_variance, track_variance);
  odometry_.covariance = slip_covariance_ + effect_ * errors.asDiagonal() * effect_.transpose();
}

}  // namespace ariadne::control
