#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ariadne::slam {

/// A rigid motion in space, SE(3). `T_map_laser * p_laser` is the point in map coordinates.
///
/// Conventions, fixed here for the whole project: a tangent vector is (translation, rotation) in
/// (m, rad), and perturbs on the right, T + tau = T * Exp(tau); so tau, and every covariance, lives in the
/// frame on the right of the name (the laser of T_map_laser).
struct Pose3 {
  static constexpr int kDof = 6;
  using Point = Eigen::Vector3d;
  using Tangent = Eigen::Matrix<double, 6, 1>;
  using Square = Eigen::Matrix<double, 6, 6>;

  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // unit length
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         // [m]

  static Pose3 Exp(const Tangent& tau);
  static Pose3 FromMatrix(const Eigen::Matrix4d& matrix);

  Tangent Log() const;
  Pose3 Inverse() const;
  Eigen::Matrix3d RotationMatrix() const { return rotation.toRotationMatrix(); }
  Eigen::Matrix4d Matrix() const;

  /// T * Exp(tau) = Exp(Ad_T tau) * T.
  Square Adjoint() const;
};

Pose3 operator*(const Pose3& T_a_b, const Pose3& T_b_c);
Eigen::Vector3d operator*(const Pose3& T_a_b, const Eigen::Vector3d& p_b);

/// The pose at share s of the way on the screw motion from `from` (s = 0) to `to` (s = 1).
Pose3 Interpolate(const Pose3& from, const Pose3& to, double s);

/// Length of the translation [m] and angle of the rotation [rad] between two poses.
double TranslationDistance(const Pose3& a, const Pose3& b);
double RotationDistance(const Pose3& a, const Pose3& b);

bool IsFinite(const Pose3& pose);

}  // namespace ariadne::slam
