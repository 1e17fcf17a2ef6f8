#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace ariadne::slam {

/// The rotation nearest to a matrix from a file, which carries the rounding of its digits; nothing where
/// R R^T departs from identity by more than 1e-3 in an entry, or R is a reflection.
std::optional<Eigen::Quaterniond> RotationFromMatrix(const Eigen::Matrix3d& R);

/// The matrix of a rotation, chosen (within 1e-14) so that RotationFromMatrix gives a quaternion with just
/// this matrix again: poses that are read and written keep their bytes.
Eigen::Matrix3d RotationMatrixForFile(const Eigen::Quaterniond& rotation);

}  // namespace ariadne::slam
