#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ariadne::slam {

/// The matrix of the cross product: Hat(a) * b = a x b.
Eigen::Matrix3d Hat(const Eigen::Vector3d& a);

/// Rotation by |theta| rad about theta.
Eigen::Quaterniond ExpSo3(const Eigen::Vector3d& theta);

/// Rotation vector in the ball |theta| <= pi; the inverse of ExpSo3 inside it.
Eigen::Vector3d LogSo3(const Eigen::Quaterniond& rotation);

/// The left Jacobian V of SO(3): Exp(theta + d) = Exp(V d) Exp(theta) to first order.
Eigen::Matrix3d LeftJacobianSo3(const Eigen::Vector3d& theta);
Eigen::Matrix3d InverseLeftJacobianSo3(const Eigen::Vector3d& theta);

}  // namespace ariadne::slam
