#include "slam/geometry/pose2.h"

#include <cmath>

#include "slam/geometry/angles.h"
#include "slam/geometry/so3.h"

namespace ariadne::slam {
namespace {

/// The matrix V of SE(2): translation of Exp(x, y, theta) = V (x, y).
Eigen::Matrix2d LeftJacobian(double theta) {
  const bool small = std::abs(theta) < 1e-3;  // below it the series is exact to rounding
  const double half_sine = std::sin(0.5 * theta);
  const double a = small ? 1.0 - theta * theta / 6.0 + std::pow(theta, 4) / 120.0 : std::sin(theta) / theta;
  const double b = small ? 0.5 * theta - std::pow(theta, 3) / 24.0 : 2.0 * half_sine * half_sine / theta;
  Eigen::Matrix2d V;
  V << a, -b, b, a;
  return V;
}

}  // namespace

Pose2 Pose2::Exp(const Tangent& tau) { return {WrapAngle(tau.z()), LeftJacobian(tau.z()) * tau.head<2>()}; }

Pose2::Tangent Pose2::Log() const {
  Tangent tau;
  tau << LeftJacobian(angle).inverse() * translation, angle;
  return tau;
}

Pose2 Pose2::Inverse() const { return {WrapAngle(-angle), -(RotationMatrix().transpose() * translation)}; }

Eigen::Matrix2d Pose2::RotationMatrix() const {
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

Pose2::Square Pose2::Adjoint() const {
  Square adjoint = Square::Identity();
  adjoint.topLeftCorner<2, 2>() = RotationMatrix();
  adjoint.topRightCorner<2, 1>() << translation.y(), -translation.x();
  return adjoint;
}

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  return {WrapAngle(T_a_b.angle + T_b_c.angle), T_a_b * T_b_c.translation};
}

Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  return T_a_b.RotationMatrix() * p_b + T_a_b.translation;
}

Pose2 Interpolate(const Pose2& from, const Pose2& to, double s) {
  return from * Pose2::Exp(s * (from.Inverse() * to).Log());
}

Pose3 ToPose3(const Pose2& pose) {
  return {ExpSo3({0.0, 0.0, pose.angle}), {pose.translation.x(), pose.translation.y(), 0.0}};
}

}  // namespace ariadne::slam
