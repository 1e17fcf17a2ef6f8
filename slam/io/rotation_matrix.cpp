#include "slam/io/rotation_matrix.h"

#include <Eigen/SVD>
#include <cmath>

namespace ariadne::slam {
namespace {

constexpr double kOrthonormal = 1e-3;
constexpr double kExact = 1e-12;

/// matrix -> quaternion -> matrix changes last digits each time. So three components are put on a grid
/// that is coarser than this noise, and the fourth follows from them.
Eigen::Quaterniond OnGrid(const Eigen::Quaterniond& rotation) {
  constexpr double kSteps = 0x1p48;
  Eigen::Vector4d q = rotation.coeffs();
  // Some component reaches 0.5. That it is the first which reaches a number that no common angle has,
  // and not the largest, keeps the choice stable where two are equal, as in a quarter turn.
  Eigen::Index dependent = 0;
  while (std::abs(q[dependent]) < 0.487) ++dependent;
  if (q[dependent] < 0.0) q = -q;
  for (double& component : q) component = std::round(component * kSteps) / kSteps + 0.0;  // no -0
  q[dependent] = 0.0;
  q[dependent] = std::sqrt(1.0 - q.squaredNorm());
  return Eigen::Quaterniond(q);
}

}  // namespace

std::optional<Eigen::Quaterniond> RotationFromMatrix(const Eigen::Matrix3d& R) {
  const double deviation = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(deviation <= kOrthonormal) || R.determinant() < 0.0) return std::nullopt;
  Eigen::Matrix3d nearest = R;
  if (deviation > kExact) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
    nearest = svd.matrixU() * svd.matrixV().transpose();
  }
  return OnGrid(Eigen::Quaterniond(nearest).normalized());
}

Eigen::Matrix3d RotationMatrixForFile(const Eigen::Quaterniond& rotation) {
  return OnGrid(rotation.normalized()).toRotationMatrix();
}

}  // namespace ariadne::slam
