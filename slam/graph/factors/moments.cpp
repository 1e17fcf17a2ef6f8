#include "slam/graph/factors/moments.h"

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

void CheckSameReference(const Pose3& a, const Pose3& b) {
  if (a.rotation.coeffs() != b.rotation.coeffs() || a.translation != b.translation)
    Fail("moments of point pairs at different reference poses cannot be added");
}

}  // namespace

void PointPairMoments::Add(const Eigen::Vector3d& p_i, const Eigen::Vector3d& p_j, double weight) {
  if (pairs_ == 0) origin_i_ = p_i;
  ++pairs_;
  Eigen::Matrix<double, 7, 1> z;
  z << p_i - origin_i_, p_j - T_j_i_reference_ * p_i, 1.0;
  sum_.noalias() += (weight * z) * z.transpose();
}

PointPairMoments& PointPairMoments::operator+=(const PointPairMoments& other) {
  CheckSameReference(T_j_i_reference_, other.T_j_i_reference_);
  if (other.pairs_ == 0) return *this;
  if (pairs_ == 0) return *this = other;
  Matrix7 shift = Matrix7::Identity();  // to this origin
  shift.topRightCorner<3, 1>() = other.origin_i_ - origin_i_;
  sum_ += shift * other.sum_ * shift.transpose();
  pairs_ += other.pairs_;
  return *this;
}

void PlanePairMoments::Add(const Eigen::Vector3d& p_i, const Eigen::Vector3d& p_j,
                           const Eigen::Matrix3d& information_j) {
  if (pairs_ == 0) origin_i_ = p_i;
  ++pairs_;
  const Eigen::Vector4d u = (p_i - origin_i_).homogeneous();  // e = [D_R d] u + e_reference
  const Eigen::Vector3d e_reference = T_j_i_reference_ * p_i - p_j;
  const Eigen::Vector3d We = information_j * e_reference;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) sum_.block<3, 3>(3 * a, 3 * b) += u[a] * u[b] * information_j;
    sum_.block<3, 1>(3 * a, 12) += u[a] * We;
    sum_.block<1, 3>(12, 3 * a) += u[a] * We.transpose();
  }
  sum_(12, 12) += e_reference.dot(We);
}

PlanePairMoments& PlanePairMoments::operator+=(const PlanePairMoments& other) {
  CheckSameReference(T_j_i_reference_, other.T_j_i_reference_);
  if (other.pairs_ == 0) return *this;
  if (pairs_ == 0) return *this = other;
  Matrix13 shift = Matrix13::Identity();  // takes y of this origin to y of the other one
  const Eigen::Vector3d offset = other.origin_i_ - origin_i_;
  for (int a = 0; a < 3; ++a) shift.block<3, 3>(9, 3 * a) = offset[a] * Eigen::Matrix3d::Identity();
  sum_ += shift.transpose() * other.sum_ * shift;
  pairs_ += other.pairs_;
  return *this;
}

}  // namespace ariadne::slam
