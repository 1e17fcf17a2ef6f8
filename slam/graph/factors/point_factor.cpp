#include "slam/graph/factors/compressed_factors.h"

#include <vector>

#include "slam/base/error.h"
#include "slam/geometry/so3.h"
#include "slam/graph/factors/pose_block.h"
#include "slam/graph/factors/square_root.h"

namespace ariadne::slam {
namespace {

using Rows3x7 = Eigen::Matrix<double, 3, 7, Eigen::RowMajor>;

/// A column of the root of the moments stands for many pairs like a pair of weight one would, whose points
/// were multiplied with `share`: r = (R_i p_i + t_i share) - (R_j p_j + t_j share).
struct VirtualPair {
  Eigen::Vector3d from_origin;  // p_i - share origin_i
  Eigen::Vector3d residual_j;   // p_j - T_j_i_reference p_i, in the frame of scan j
  double share;
  Eigen::Vector3d p_i;
  Eigen::Vector3d p_j;
};

class PointFactor final : public ceres::CostFunction {
 public:
  explicit PointFactor(const PointPairMoments& moments)
      : R_j_i_reference_(moments.T_j_i_reference().RotationMatrix()),
        origin_i_(moments.origin_i()),
        origin_j_(moments.T_j_i_reference() * origin_i_) {
    const Eigen::MatrixXd L = SquareRoot(moments.sum(), "the moment matrix of point pairs");
    for (const auto& column : L.colwise()) AddPair(column);
    *mutable_parameter_block_sizes() = {kBlockSize<Pose3>, kBlockSize<Pose3>};
    set_num_residuals(3 * static_cast<int>(pairs_.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Pose3 T_map_i = FromBlock<Pose3>(parameters[0]);
    const Pose3 T_map_j = FromBlock<Pose3>(parameters[1]);
    const Eigen::Matrix3d R_i = T_map_i.RotationMatrix();
    const Eigen::Matrix3d R_j = T_map_j.RotationMatrix();
    // What a residual differs by from the one at the reference pose: zeros there, but for the last digit.
    const Eigen::Matrix3d D_R = R_i - R_j * R_j_i_reference_;
    const Eigen::Vector3d d =
        (T_map_i.translation - T_map_j.translation) + (R_i * origin_i_ - R_j * origin_j_);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const VirtualPair& pair = pairs_[k];
      Eigen::Map<Eigen::Vector3d>(residuals + 3 * k) =
          D_R * pair.from_origin - R_j * pair.residual_j + pair.share * d;
      if (jacobians == nullptr) continue;
      if (jacobians[0] != nullptr) WriteJacobian(R_i, pair.p_i, pair.share, jacobians[0] + 21 * k);
      if (jacobians[1] != nullptr) WriteJacobian(-R_j, pair.p_j, pair.share, jacobians[1] + 21 * k);
    }
    return true;
  }

 private:
  void AddPair(const Eigen::Matrix<double, 7, 1>& column) {
    VirtualPair pair{column.head<3>(), column.segment<3>(3), column[6], {}, {}};
    pair.p_i = pair.from_origin + pair.share * origin_i_;
    pair.p_j = pair.residual_j + R_j_i_reference_ * pair.from_origin + pair.share * origin_j_;
    pairs_.push_back(pair);
  }

  /// The derivative of R p + share t by the tangent of its pose.
  static void WriteJacobian(const Eigen::Matrix3d& R, const Eigen::Vector3d& p, double share,
                            double* jacobian) {
    Eigen::Map<Rows3x7>(jacobian) << share * R, -R * Hat(p), Eigen::Vector3d::Zero();
  }

  Eigen::Matrix3d R_j_i_reference_;
  Eigen::Vector3d origin_i_;
  Eigen::Vector3d origin_j_;  // T_j_i_reference origin_i
  std::vector<VirtualPair> pairs_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakePointFactor(const PointPairMoments& moments) {
  if (moments.pairs() == 0) Fail("a factor of point pairs needs at least one pair");
  return std::make_unique<PointFactor>(moments);
}

}  // namespace ariadne::slam
