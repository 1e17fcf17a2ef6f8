#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// A rigid motion in the plane, SE(2), with the conventions of Pose3: the tangent is (x, y, theta) in
/// (m, rad) and perturbs on the right.
struct Pose2 {
  static constexpr int kDof = 3;
  using Point = Eigen::Vector2d;
  using Tangent = Eigen::Vector3d;
  using Square = Eigen::Matrix3d;

  double angle = 0.0;                                     // [rad], in (-pi, pi]
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  // [m]

  static Pose2 Exp(const Tangent& tau);
  Tangent Log() const;
  Pose2 Inverse() const;
  Eigen::Matrix2d RotationMatrix() const;

  /// T * Exp(tau) = Exp(Ad_T tau) * T.
  Square Adjoint() const;
};

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c);
Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b);

/// The pose at share s of the way on the arc from `from` (s = 0) to `to` (s = 1).
Pose2 Interpolate(const Pose2& from, const Pose2& to, double s);

/// The planar motion as a motion in space, in the plane z = 0.
Pose3 ToPose3(const Pose2& pose);

}  // namespace ariadne::slam
