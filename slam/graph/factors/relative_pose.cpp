#include "slam/graph/factors/relative_pose.h"

#include <ceres/sized_cost_function.h>

#include "slam/graph/factors/pose_block.h"
#include "slam/graph/factors/square_root.h"
#include "slam/graph/linearize.h"

namespace ariadne::slam {
namespace {

/// Writes U times the derivative by a tangent as the Jacobian by the pose's block (PoseManifold).
template <typename Pose>
void WriteJacobian(const typename Pose::Square& derivative, double* jacobian) {
  constexpr int kColumns = kBlockSize<Pose>;
  if (jacobian == nullptr) return;
  Eigen::Map<Eigen::Matrix<double, Pose::kDof, kColumns, Eigen::RowMajor>> rows(jacobian);
  rows.template leftCols<Pose::kDof>() = derivative;
  rows.template rightCols<kColumns - Pose::kDof>().setZero();
}

template <typename Pose>
class RelativePoseFactor final
    : public ceres::SizedCostFunction<Pose::kDof, kBlockSize<Pose>, kBlockSize<Pose>> {
 public:
  RelativePoseFactor(const PoseEdge<Pose>& edge, RotationError rotation_error)
      : measured_(edge.T_from_to),
        root_(RootOfInformation<Pose>(edge.information)),
        rotation_error_(rotation_error) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const LinearError<Pose> linear =
        Linearize(measured_, RotatedPose<Pose>(FromBlock<Pose>(parameters[0])),
                  RotatedPose<Pose>(FromBlock<Pose>(parameters[1])), rotation_error_);
    Eigen::Map<typename Pose::Tangent>(residuals).noalias() = root_ * linear.e;
    if (jacobians == nullptr) return true;
    WriteJacobian<Pose>(root_ * linear.J_from, jacobians[0]);
    WriteJacobian<Pose>(root_ * linear.J_to, jacobians[1]);
    return true;
  }

 private:
  RotatedPose<Pose> measured_;
  typename Pose::Square root_;
  RotationError rotation_error_;
};

template <typename Pose>
class PriorFactor final : public ceres::SizedCostFunction<Pose::kDof, kBlockSize<Pose>> {
 public:
  PriorFactor(const PosePrior<Pose>& prior, RotationError rotation_error)
      : measured_(prior.T_map_node),
        root_(RootOfInformation<Pose>(prior.information)),
        rotation_error_(rotation_error) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const RotatedPose<Pose> T_map_node(FromBlock<Pose>(parameters[0]));
    const LinearError<Pose> linear = Linearize(measured_, RotatedPose<Pose>(), T_map_node, rotation_error_);
    Eigen::Map<typename Pose::Tangent>(residuals).noalias() = root_ * linear.e;
    if (jacobians != nullptr) WriteJacobian<Pose>(root_ * linear.J_to, jacobians[0]);
    return true;
  }

 private:
  RotatedPose<Pose> measured_;
  typename Pose::Square root_;
  RotationError rotation_error_;
};

}  // namespace

template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakeRelativePoseFactor(const PoseEdge<Pose>& edge,
                                                            RotationError rotation_error) {
  return std::make_unique<RelativePoseFactor<Pose>>(edge, rotation_error);
}

template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakePriorFactor(const PosePrior<Pose>& prior,
                                                     RotationError rotation_error) {
  return std::make_unique<PriorFactor<Pose>>(prior, rotation_error);
}

using Factor = std::unique_ptr<ceres::CostFunction>;
template Factor MakeRelativePoseFactor(const PoseEdge<Pose2>&, RotationError);
template Factor MakeRelativePoseFactor(const PoseEdge<Pose3>&, RotationError);
template Factor MakePriorFactor(const PosePrior<Pose2>&, RotationError);
template Factor MakePriorFactor(const PosePrior<Pose3>&, RotationError);

}  // namespace ariadne::slam
