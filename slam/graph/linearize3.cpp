#include "slam/geometry/so3.h"
#include "slam/graph/linearize.h"

namespace ariadne::slam {

// With C = T_map_from^-1 T_map_to, a step of `to` makes C Exp(tau), and one of `from` makes Exp(-tau) C.

LinearError<Pose3> Linearize(const RotatedPose<Pose3>& measured, const RotatedPose<Pose3>& T_map_from,
                             const RotatedPose<Pose3>& T_map_to, RotationError) {
  LinearError<Pose3> linear;
  linear.R_from_to = T_map_from.R.transpose() * T_map_to.R;
  linear.to_from = T_map_from.R.transpose() * (T_map_to.pose.translation - T_map_from.pose.translation);
  const Eigen::Quaterniond q =
      measured.pose.rotation.conjugate() * (T_map_from.pose.rotation.conjugate() * T_map_to.pose.rotation);
  linear.difference.rotation = q.w() < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : q;
  linear.difference.translation = measured.R.transpose() * (linear.to_from - measured.pose.translation);

  const Eigen::Vector3d v = linear.difference.rotation.vec();
  Eigen::Matrix3d J_angle = Hat(v);
  J_angle.diagonal().array() += linear.difference.rotation.w();
  linear.e << linear.difference.translation, 2.0 * v;
  linear.J_to << measured.R.transpose() * linear.R_from_to, Eigen::Matrix3d::Zero(),
      Eigen::Matrix3d::Zero(), J_angle;
  linear.J_from << -measured.R.transpose(), measured.R.transpose() * Hat(linear.to_from),
      Eigen::Matrix3d::Zero(), -J_angle * linear.R_from_to.transpose();
  return linear;
}

Curvature<Pose3> CurvatureOf(const Pose3::Tangent& y, const LinearError<Pose3>& linear,
                             const RotatedPose<Pose3>& measured, RotationError) {
  // y_t.e_t = s.Exp(-phi_from)(u + C rho_to - rho_from) + const, with s and u in the frame of `from`.
  const Eigen::Vector3d s = measured.R * y.head<3>();
  const Eigen::Vector3d& u = linear.to_from;
  const Eigen::Matrix3d s_hat = Hat(s);
  // y_v.e_v = 2 y_v.vec(q(a)^-1 q q(b)), with a = R_measured^T phi_from and b = phi_to.
  const Eigen::Vector3d v = linear.difference.rotation.vec();
  const Eigen::Vector3d y_v = y.tail<3>();
  const double along = y_v.dot(v);
  Eigen::Matrix3d mixed =
      0.5 * (v * y_v.transpose() + y_v * v.transpose() + linear.difference.rotation.w() * Hat(y_v));
  mixed.diagonal().array() -= 0.5 * along;

  Curvature<Pose3> curvature{Pose3::Square::Zero(), Pose3::Square::Zero(), Pose3::Square::Zero()};
  Eigen::Matrix3d turn = 0.5 * (s * u.transpose() + u * s.transpose());
  turn.diagonal().array() -= s.dot(u) + 0.5 * along;
  curvature.from_from.bottomRightCorner<3, 3>() = turn;
  curvature.from_from.bottomLeftCorner<3, 3>() = -s_hat;
  curvature.from_from.topRightCorner<3, 3>() = s_hat;
  curvature.from_to.bottomLeftCorner<3, 3>() = s_hat * linear.R_from_to;
  curvature.from_to.bottomRightCorner<3, 3>() = measured.R * mixed;
  curvature.to_to.diagonal().tail<3>().setConstant(-0.5 * along);
  return curvature;
}

Pose3 Retract(const Pose3& pose, const Pose3::Tangent& tau) {
  const Eigen::Vector3d rho = tau.head<3>(), phi = tau.tail<3>();
  return {(pose.rotation * ExpSo3(phi)).normalized(), pose.translation + pose.rotation * rho};
}

}  // namespace ariadne::slam
