#pragma once

#include <ceres/manifold.h>

#include <array>
#include <memory>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// How many numbers Ceres holds for a pose: (x, y, angle), or the quaternion x, y, z, w and the
/// translation.
template <typename Pose>
inline constexpr int kBlockSize = Pose::kDof;
template <>
inline constexpr int kBlockSize<Pose3> = 7;

/// A pose as a parameter block of Ceres.
template <typename Pose>
using PoseBlock = std::array<double, kBlockSize<Pose>>;

PoseBlock<Pose2> ToBlock(const Pose2& pose);
PoseBlock<Pose3> ToBlock(const Pose3& pose);

template <typename Pose>
Pose FromBlock(const double* block);
template <>
Pose2 FromBlock<Pose2>(const double* block);
template <>
Pose3 FromBlock<Pose3>(const double* block);

/// The manifold of a pose's block: Plus is T * Exp(tau), in the tangent space of geometry/pose3.h.
///
/// Every factor of this folder writes its derivatives by the tangent into the first columns of its
/// Jacobian, and zeros into the seventh one. So PlusJacobian is [I; 0]. Ceres only uses the product of the
/// two, which is the derivative by the tangent; but a block with this manifold must not meet factors of
/// other makers.
template <typename Pose>
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return kBlockSize<Pose>; }
  int TangentSize() const override { return Pose::kDof; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool RightMultiplyByPlusJacobian(const double* x, int num_rows, const double* ambient_matrix,
                                   double* tangent_matrix) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  /// [I 0]: the inverse of PlusJacobian where that has one.
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

}  // namespace ariadne::slam
