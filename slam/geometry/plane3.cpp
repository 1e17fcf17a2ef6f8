#include "slam/geometry/plane3.h"

#include <Eigen/Eigenvalues>

namespace ariadne::slam {

Plane3 operator*(const Pose3& T_a_b, const Plane3& plane_b) {
  const Eigen::Vector3d normal_a = T_a_b.rotation * plane_b.normal;
  return {normal_a, plane_b.offset + normal_a.dot(T_a_b.translation)};
}

void PointMoments::Add(const Eigen::Vector3d& p) {
  const Eigen::Vector3d local = p - origin_;
  sum_ += local;
  sum_of_squares_ += local * local.transpose();
  ++count_;
}

Eigen::Matrix3d PointMoments::Covariance() const {
  const Eigen::Vector3d mean = sum_ / count_;
  return sum_of_squares_ / count_ - mean * mean.transpose();
}

PlaneFit FitPlane(const PointMoments& moments) {
  // The closed form is several times faster than the iterative solver; its loss of digits (relative to
  // the largest variance) does not matter for points of a few centimetres around the mean.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.Covariance());
  const Eigen::Vector3d normal = solver.eigenvectors().col(0).normalized();
  return {{normal, normal.dot(moments.Mean())}, solver.eigenvalues().cwiseMax(0.0)};
}

}  // namespace ariadne::slam
