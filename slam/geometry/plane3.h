#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// The plane normal . p = offset.
struct Plane3 {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit length
  double offset = 0.0;                                // [m]

  /// Signed: positive on the side to which the normal points. [m]
  double Distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

/// T_a_b * plane_b is the same plane in frame a.
Plane3 operator*(const Pose3& T_a_b, const Plane3& plane_b);

/// Centroid and scatter of a set of points, gathered one by one.
class PointMoments {
 public:
  /// Coordinates are gathered relative to `origin`; one near the points keeps all digits.
  explicit PointMoments(const Eigen::Vector3d& origin) : origin_(origin) {}

  void Add(const Eigen::Vector3d& p);
  int count() const { return count_; }
  Eigen::Vector3d Mean() const { return origin_ + sum_ / count_; }
  /// (1/n) sum (p - mean)(p - mean)^T  [m^2]
  Eigen::Matrix3d Covariance() const;

 private:
  Eigen::Vector3d origin_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sum_of_squares_ = Eigen::Matrix3d::Zero();
  int count_ = 0;
};

/// The plane of least squared distances, and how well it fits.
struct PlaneFit {
  Plane3 plane;
  Eigen::Vector3d variances =
      Eigen::Vector3d::Zero();  // of the points along normal, middle, longest axis, [m^2]
};

/// Total least squares through at least three points; the normal's sign is arbitrary.
PlaneFit FitPlane(const PointMoments& moments);

}  // namespace ariadne::slam
