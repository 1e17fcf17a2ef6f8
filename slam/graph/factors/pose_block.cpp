#include "slam/graph/factors/pose_block.h"

#include <algorithm>

#include "slam/graph/factors/between.h"

namespace ariadne::slam {
namespace {

template <int kRows, int kColumns>
bool WriteIdentity(double* matrix) {
  Eigen::Map<Eigen::Matrix<double, kRows, kColumns, Eigen::RowMajor>>(matrix).setIdentity();
  return true;
}

}  // namespace

PoseBlock<Pose2> ToBlock(const Pose2& pose) {
  return {pose.translation.x(), pose.translation.y(), pose.angle};
}

PoseBlock<Pose3> ToBlock(const Pose3& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  const Eigen::Vector3d& t = pose.translation;
  return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()};
}

template <>
Pose2 FromBlock<Pose2>(const double* block) {
  return {block[2], {block[0], block[1]}};
}

template <>
Pose3 FromBlock<Pose3>(const double* block) {
  return {Eigen::Quaterniond(block), Eigen::Vector3d(block + 4)};
}

template <typename Pose>
bool PoseManifold<Pose>::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Eigen::Map<const typename Pose::Tangent> tau(delta);
  const PoseBlock<Pose> block = ToBlock(FromBlock<Pose>(x) * Pose::Exp(tau));
  std::ranges::copy(block, x_plus_delta);
  return true;
}

template <typename Pose>
bool PoseManifold<Pose>::PlusJacobian(const double*, double* jacobian) const {
  return WriteIdentity<kBlockSize<Pose>, Pose::kDof>(jacobian);
}

template <typename Pose>
bool PoseManifold<Pose>::RightMultiplyByPlusJacobian(const double*, int num_rows,
                                                     const double* ambient_matrix,
                                                     double* tangent_matrix) const {
  for (int row = 0; row < num_rows; ++row)
    std::copy_n(ambient_matrix + row * kBlockSize<Pose>, Pose::kDof, tangent_matrix + row * Pose::kDof);
  return true;
}

template <typename Pose>
bool PoseManifold<Pose>::Minus(const double* y, const double* x, double* y_minus_x) const {
  const typename Pose::Tangent tau = Between(FromBlock<Pose>(x), FromBlock<Pose>(y)).Log();
  std::ranges::copy(tau, y_minus_x);
  return true;
}

template <typename Pose>
bool PoseManifold<Pose>::MinusJacobian(const double*, double* jacobian) const {
  return WriteIdentity<Pose::kDof, kBlockSize<Pose>>(jacobian);
}

template class PoseManifold<Pose2>;
template class PoseManifold<Pose3>;

}  // namespace ariadne::slam
