#include <cmath>

#include "slam/geometry/angles.h"
#include "slam/graph/linearize.h"

namespace ariadne::slam {
namespace {

/// By a quarter turn to the left: the derivative of a rotation by its angle.
Eigen::Vector2d Turned(const Eigen::Vector2d& p) { return {-p.y(), p.x()}; }

}  // namespace

LinearError<Pose2> Linearize(const RotatedPose<Pose2>& measured, const RotatedPose<Pose2>& T_map_from,
                             const RotatedPose<Pose2>& T_map_to, RotationError rotation_error) {
  LinearError<Pose2> linear;
  linear.R_from_to = T_map_from.R.transpose() * T_map_to.R;
  linear.to_from = T_map_from.R.transpose() * (T_map_to.pose.translation - T_map_from.pose.translation);
  linear.difference.angle = WrapAngle(T_map_to.pose.angle - T_map_from.pose.angle - measured.pose.angle);
  linear.difference.translation = measured.R.transpose() * (linear.to_from - measured.pose.translation);

  const double half = 0.5 * linear.difference.angle;
  const bool chord = rotation_error == RotationError::kChord;
  linear.e << linear.difference.translation, chord ? 2.0 * std::sin(half) : linear.difference.angle;
  linear.J_to.setZero();
  linear.J_to.topLeftCorner<2, 2>() = measured.R.transpose() * linear.R_from_to;
  linear.J_to(2, 2) = chord ? std::cos(half) : 1.0;
  linear.J_from.setZero();
  linear.J_from.topLeftCorner<2, 2>() = -measured.R.transpose();
  linear.J_from.topRightCorner<2, 1>() = -(measured.R.transpose() * Turned(linear.to_from));
  linear.J_from(2, 2) = -linear.J_to(2, 2);
  return linear;
}

Curvature<Pose2> CurvatureOf(const Pose2::Tangent& y, const LinearError<Pose2>& linear,
                             const RotatedPose<Pose2>& measured, RotationError rotation_error) {
  // y_t.e_t = s.R(-phi_from)(u + C rho_to - rho_from) + const, with s and u in the frame of `from`.
  const Eigen::Vector2d s = measured.R * y.head<2>();
  const Eigen::Vector2d s_turned = Turned(s);
  const double bend = rotation_error == RotationError::kChord ? -0.25 * linear.e[2] * y[2] : 0.0;
  Curvature<Pose2> curvature{Pose2::Square::Zero(), Pose2::Square::Zero(), Pose2::Square::Zero()};
  curvature.from_from(2, 2) = -s.dot(linear.to_from) + bend;
  curvature.from_from.bottomLeftCorner<1, 2>() = -s_turned.transpose();
  curvature.from_from.topRightCorner<2, 1>() = -s_turned;
  curvature.from_to.bottomLeftCorner<1, 2>() = s_turned.transpose() * linear.R_from_to;
  curvature.from_to(2, 2) = -bend;
  curvature.to_to(2, 2) = bend;
  return curvature;
}

Pose2 Retract(const Pose2& pose, const Pose2::Tangent& tau) {
  return {WrapAngle(pose.angle + tau[2]), pose.translation + pose.RotationMatrix() * tau.head<2>()};
}

}  // namespace ariadne::slam
