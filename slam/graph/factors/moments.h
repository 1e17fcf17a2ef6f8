#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

/// Sums over the point pairs of two scans i and j with which their energy is known at every pose, exactly,
/// however many pairs there are. Points of scan i are p_i, in its own frame; points of scan j p_j.
///
/// Sums over raw coordinates would lose the digits of small residuals. So points enter relative to the
/// first point that was added, and residuals relative to those at a reference pose: the closer the
/// reference is to the poses at which the energy is wanted, the more digits remain (all, if it is where the
/// pairs were found). Partial sums of chunks may be added with +=, in a fixed order; all need the same
/// reference.
namespace ariadne::slam {

/// Of the energy sum w |T_map_i p_i - T_map_j p_j|^2: the moment matrix of (p_i, p_j, 1).
class PointPairMoments {
 public:
  using Matrix7 = Eigen::Matrix<double, 7, 7>;

  explicit PointPairMoments(const Pose3& T_j_i_reference = {}) : T_j_i_reference_(T_j_i_reference) {}

  /// A pair of points [m] with its weight >= 0.
  void Add(const Eigen::Vector3d& p_i, const Eigen::Vector3d& p_j, double weight = 1.0);
  PointPairMoments& operator+=(const PointPairMoments& other);

  std::size_t pairs() const { return pairs_; }
  double weight() const { return sum_(6, 6); }
  const Pose3& T_j_i_reference() const { return T_j_i_reference_; }
  const Eigen::Vector3d& origin_i() const { return origin_i_; }

  /// sum w z z^T with z = (p_i - origin_i, p_j - T_j_i_reference p_i, 1).
  const Matrix7& sum() const { return sum_; }

 private:
  Pose3 T_j_i_reference_;
  Eigen::Vector3d origin_i_ = Eigen::Vector3d::Zero();
  Matrix7 sum_ = Matrix7::Zero();
  std::size_t pairs_ = 0;
};

/// Of the energy sum e^T W e with e = T_j_i p_i - p_j in the frame of scan j, each pair with a symmetric
/// positive semidefinite W of its own: it is quadratic in the 12 entries of T_j_i.
/// For point-to-plane W = w n_j n_j^T; for plane-to-plane the information of the difference of the points.
class PlanePairMoments {
 public:
  using Matrix13 = Eigen::Matrix<double, 13, 13>;

  explicit PlanePairMoments(const Pose3& T_j_i_reference = {}) : T_j_i_reference_(T_j_i_reference) {}

  /// A pair of points [m] with its information in the frame of scan j.
  void Add(const Eigen::Vector3d& p_i, const Eigen::Vector3d& p_j, const Eigen::Matrix3d& information_j);
  PlanePairMoments& operator+=(const PlanePairMoments& other);

  std::size_t pairs() const { return pairs_; }
  const Pose3& T_j_i_reference() const { return T_j_i_reference_; }
  const Eigen::Vector3d& origin_i() const { return origin_i_; }

  /// The quadratic form of y = (columns of D_R, d, 1), where D_R and d are what the rotation of T_j_i, and
  /// T_j_i origin_i, have more than those of the reference.
  const Matrix13& sum() const { return sum_; }

 private:
  Pose3 T_j_i_reference_;
  Eigen::Vector3d origin_i_ = Eigen::Vector3d::Zero();
  Matrix13 sum_ = Matrix13::Zero();
  std::size_t pairs_ = 0;
};

}  // namespace ariadne::slam
