#include "slam/graph/factors/compressed_factors.h"

#include <ceres/sized_cost_function.h>

#include "slam/base/error.h"
#include "slam/geometry/so3.h"
#include "slam/graph/factors/between.h"
#include "slam/graph/factors/pose_block.h"
#include "slam/graph/factors/square_root.h"

namespace ariadne::slam {
namespace {

using Vector13 = Eigen::Matrix<double, 13, 1>;
using Columns6 = Eigen::Matrix<double, 12, 6>;
using Rows13x7 = Eigen::Matrix<double, 13, 7, Eigen::RowMajor>;

/// The residuals are L^T y with y as in PlanePairMoments::sum, whose root is L.
class PlaneFactor final : public ceres::SizedCostFunction<13, kBlockSize<Pose3>, kBlockSize<Pose3>> {
 public:
  explicit PlaneFactor(const PlanePairMoments& moments)
      : R_j_i_reference_(moments.T_j_i_reference().RotationMatrix()),
        origin_i_(moments.origin_i()),
        origin_j_(moments.T_j_i_reference() * origin_i_) {
    const Eigen::MatrixXd L = SquareRoot(moments.sum(), "the moment matrix of point-to-plane pairs");
    L_transposed_.topRows(L.cols()) = L.transpose();
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Pose3 T_j_i = Between(FromBlock<Pose3>(parameters[1]), FromBlock<Pose3>(parameters[0]));
    const Eigen::Matrix3d R_j_i = T_j_i.RotationMatrix();
    const Eigen::Vector3d origin_j = T_j_i.translation + R_j_i * origin_i_;  // present place of origin_i
    Vector13 y;
    y.head<9>() = (R_j_i - R_j_i_reference_).reshaped();
    y.segment<3>(9) = origin_j - origin_j_;
    y[12] = 1.0;
    Eigen::Map<Vector13>(residuals).noalias() = L_transposed_ * y;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) WriteJacobian(DerivativeByI(R_j_i), jacobians[0]);
    if (jacobians[1] != nullptr) WriteJacobian(DerivativeByJ(R_j_i, origin_j), jacobians[1]);
    return true;
  }

 private:
  /// Of y by the tangent of T_map_i, which perturbs T_j_i on the right.
  Columns6 DerivativeByI(const Eigen::Matrix3d& R_j_i) const {
    Columns6 derivative = Columns6::Zero();
    for (int k = 0; k < 3; ++k) derivative.block<3, 3>(3 * k, 3) = -R_j_i * Hat(Eigen::Vector3d::Unit(k));
    derivative.bottomRows<3>() << R_j_i, -R_j_i * Hat(origin_i_);
    return derivative;
  }

  /// Of y by the tangent of T_map_j, which perturbs T_j_i on the left, the other way.
  static Columns6 DerivativeByJ(const Eigen::Matrix3d& R_j_i, const Eigen::Vector3d& origin_j) {
    Columns6 derivative = Columns6::Zero();
    for (int k = 0; k < 3; ++k) derivative.block<3, 3>(3 * k, 3) = Hat(R_j_i.col(k));
    derivative.bottomRows<3>() << -Eigen::Matrix3d::Identity(), Hat(origin_j);
    return derivative;
  }

  void WriteJacobian(const Columns6& derivative, double* jacobian) const {
    Eigen::Map<Rows13x7> rows(jacobian);
    rows.leftCols<3>().noalias() = L_transposed_.middleCols<3>(9) * derivative.bottomLeftCorner<3, 3>();
    rows.middleCols<3>(3).noalias() = L_transposed_.leftCols<12>() * derivative.rightCols<3>();
    rows.col(6).setZero();
  }

  Eigen::Matrix3d R_j_i_reference_;
  Eigen::Vector3d origin_i_;
  Eigen::Vector3d origin_j_;  // T_j_i_reference origin_i
  PlanePairMoments::Matrix13 L_transposed_ = PlanePairMoments::Matrix13::Zero();
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakePlaneFactor(const PlanePairMoments& moments) {
  if (moments.pairs() == 0) Fail("a factor of point-to-plane pairs needs at least one pair");
  return std::make_unique<PlaneFactor>(moments);
}

}  // namespace ariadne::slam
