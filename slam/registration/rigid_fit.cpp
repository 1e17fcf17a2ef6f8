#include "slam/registration/rigid_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace ariadne::slam {
namespace {

// Pairs whose spread across their line is below this share of the spread along it fix no rotation about it:
// 1e-6 is a millimetre across a kilometre, squared in S.
constexpr double kUniqueness = 1e-12;

Eigen::Vector3d ModelCentroid(const PairMoments& moments) {
  return moments.sum.bottomLeftCorner<1, 3>().transpose() / moments.weight();
}

Eigen::Vector3d DataCentroid(const PairMoments& moments) {
  return moments.sum.topRightCorner<3, 1>() / moments.weight();
}

/// S = sum w d' m'^T with both centroids removed; its element (a, b) is the S_ab of the specification.
Eigen::Matrix3d CenteredCrossMoment(const PairMoments& moments) {
  const Eigen::Vector3d c_data = DataCentroid(moments);
  return moments.sum.topLeftCorner<3, 3>() - c_data * moments.sum.bottomLeftCorner<1, 3>();
}

Pose3 WithTranslation(const Eigen::Quaterniond& rotation, const PairMoments& moments) {
  return {rotation, ModelCentroid(moments) - rotation * DataCentroid(moments)};
}

}  // namespace

PairMoments& PairMoments::operator+=(const PairMoments& other) {
  sum += other.sum;
  sum_squared_distance += other.sum_squared_distance;
  pairs += other.pairs;
  return *this;
}

RigidFit FitByQuaternion(const PairMoments& moments) {
  const Eigen::Matrix3d S = CenteredCrossMoment(moments);
  const Eigen::Vector3d skew(S(1, 2) - S(2, 1), S(2, 0) - S(0, 2), S(0, 1) - S(1, 0));
  Eigen::Matrix4d N;
  N(0, 0) = S.trace();
  N.topRightCorner<1, 3>() = skew.transpose();
  N.bottomLeftCorner<3, 1>() = skew;
  N.bottomRightCorner<3, 3>() = S + S.transpose() - S.trace() * Eigen::Matrix3d::Identity();

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(N);  // ascending eigenvalues
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  const double sign = q(0) < 0.0 ? -1.0 : 1.0;  // q and -q are the same rotation; q0 >= 0 (Sec. 3.1)
  const Eigen::Quaterniond rotation(sign * q(0), sign * q(1), sign * q(2), sign * q(3));
  const double gap = solver.eigenvalues()(3) - solver.eigenvalues()(2);
  return {WithTranslation(rotation.normalized(), moments), gap > kUniqueness * solver.eigenvalues()(3)};
}

RigidFit FitBySvd(const PairMoments& moments) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(CenteredCrossMoment(moments),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  // H = sum d' m'^T = U D V^T gives R = V U^T; the sign guards against a reflection.
  const Eigen::Matrix3d& U = svd.matrixU();
  const Eigen::Matrix3d& V = svd.matrixV();
  const double sign = (V * U.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d R = V * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * U.transpose();
  const Eigen::Vector3d& d = svd.singularValues();
  const double gap = d(1) + sign * d(2);  // half of the gap of Horn's eigenvalues
  return {WithTranslation(Eigen::Quaterniond(R).normalized(), moments), gap > kUniqueness * d(0)};
}

}  // namespace ariadne::slam
