#include "slam/geometry/so3.h"

#include <cmath>

namespace ariadne::slam {
namespace {

// Below this angle [rad] the closed forms lose digits to cancellation, and the first terms of the series,
// whose error is of fourth order and more, are exact to rounding.
constexpr double kSmallAngle = 1e-3;

}  // namespace

Eigen::Matrix3d Hat(const Eigen::Vector3d& a) {
  Eigen::Matrix3d hat;
  hat << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return hat;
}

Eigen::Quaterniond ExpSo3(const Eigen::Vector3d& theta) {
  const double squared = theta.squaredNorm();
  const double angle = std::sqrt(squared);
  const double scale = angle < kSmallAngle ? 0.5 - squared / 48.0 + squared * squared / 3840.0
                                           : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond rotation;
  rotation.w() = std::cos(0.5 * angle);
  rotation.vec() = scale * theta;
  return rotation.normalized();
}

Eigen::Vector3d LogSo3(const Eigen::Quaterniond& rotation) {
  // q and -q are the same rotation; w >= 0 selects the angle in [0, pi].
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const double sine = rotation.vec().norm();
  const double cosine = std::abs(rotation.w());
  const double tangent = sine / cosine;
  const double squared = tangent * tangent;
  const double scale = sine < kSmallAngle ? 2.0 / cosine * (1.0 - squared / 3.0 + squared * squared / 5.0)
                                          : 2.0 * std::atan2(sine, cosine) / sine;
  return sign * scale * rotation.vec();
}

Eigen::Matrix3d LeftJacobianSo3(const Eigen::Vector3d& theta) {
  const double squared = theta.squaredNorm();
  const double angle = std::sqrt(squared);
  const bool small = angle < kSmallAngle;
  const double half_sine = std::sin(0.5 * angle);  // 1 - cos(a) = 2 sin^2(a/2), without cancellation
  const double a = small ? 0.5 - squared / 24.0 : 2.0 * half_sine * half_sine / squared;
  const double b = small ? 1.0 / 6.0 - squared / 120.0 : (angle - std::sin(angle)) / (squared * angle);
  const Eigen::Matrix3d hat = Hat(theta);
  return Eigen::Matrix3d::Identity() + a * hat + b * hat * hat;
}

Eigen::Matrix3d InverseLeftJacobianSo3(const Eigen::Vector3d& theta) {
  const double squared = theta.squaredNorm();
  const double angle = std::sqrt(squared);
  const double c = angle < kSmallAngle ? 1.0 / 12.0 + squared / 720.0
                                       : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / squared;
  const Eigen::Matrix3d hat = Hat(theta);
  return Eigen::Matrix3d::Identity() - 0.5 * hat + c * hat * hat;
}

}  // namespace ariadne::slam
