#include "slam/geometry/pose3.h"

#include "slam/geometry/so3.h"

namespace ariadne::slam {

Pose3 Pose3::Exp(const Tangent& tau) {
  const Eigen::Vector3d theta = tau.tail<3>();
  return {ExpSo3(theta), LeftJacobianSo3(theta) * tau.head<3>()};
}

Pose3 Pose3::FromMatrix(const Eigen::Matrix4d& matrix) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  return {Eigen::Quaterniond(rotation).normalized(), matrix.topRightCorner<3, 1>()};
}

Pose3::Tangent Pose3::Log() const {
  const Eigen::Vector3d theta = LogSo3(rotation);
  Tangent tau;
  tau << InverseLeftJacobianSo3(theta) * translation, theta;
  return tau;
}

Pose3 Pose3::Inverse() const {
  const Eigen::Quaterniond inverse = rotation.conjugate();
  return {inverse, -(inverse * translation)};
}

Eigen::Matrix4d Pose3::Matrix() const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = RotationMatrix();
  matrix.topRightCorner<3, 1>() = translation;
  return matrix;
}

Pose3::Square Pose3::Adjoint() const {
  const Eigen::Matrix3d R = RotationMatrix();
  Square adjoint;
  adjoint << R, Hat(translation) * R, Eigen::Matrix3d::Zero(), R;
  return adjoint;
}

Pose3 operator*(const Pose3& T_a_b, const Pose3& T_b_c) {
  return {(T_a_b.rotation * T_b_c.rotation).normalized(), T_a_b * T_b_c.translation};
}

Eigen::Vector3d operator*(const Pose3& T_a_b, const Eigen::Vector3d& p_b) {
  return T_a_b.rotation * p_b + T_a_b.translation;
}

Pose3 Interpolate(const Pose3& from, const Pose3& to, double s) {
  return from * Pose3::Exp(s * (from.Inverse() * to).Log());
}

double TranslationDistance(const Pose3& a, const Pose3& b) {
  return (a.translation - b.translation).norm();
}

double RotationDistance(const Pose3& a, const Pose3& b) {
  return LogSo3(a.rotation.conjugate() * b.rotation).norm();
}

bool IsFinite(const Pose3& pose) {
  return pose.rotation.coeffs().allFinite() && pose.translation.allFinite();
}

}  // namespace ariadne::slam
