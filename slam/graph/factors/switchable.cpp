#include "slam/graph/factors/switchable.h"

#include <ceres/sized_cost_function.h>

#include <algorithm>

#include "slam/graph/factors/pose_block.h"
#include "slam/graph/factors/relative_pose.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
class SwitchableFactor final
    : public ceres::SizedCostFunction<Pose::kDof, kBlockSize<Pose>, kBlockSize<Pose>, 1> {
 public:
  SwitchableFactor(const PoseEdge<Pose>& edge, RotationError rotation_error)
      : factor_(MakeRelativePoseFactor(edge, rotation_error)) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const double x = parameters[2][0];
    factor_->Evaluate(parameters, residuals, jacobians);
    if (jacobians != nullptr) {
      for (const int k : {0, 1})
        if (jacobians[k] != nullptr) Scale(x, Pose::kDof * kBlockSize<Pose>, jacobians[k]);
      if (jacobians[2] != nullptr) std::copy_n(residuals, Pose::kDof, jacobians[2]);
    }
    Scale(x, Pose::kDof, residuals);
    return true;
  }

 private:
  static void Scale(double x, int count, double* values) {
    std::for_each_n(values, count, [x](double& value) { value *= x; });
  }

  std::unique_ptr<ceres::CostFunction> factor_;
};

class SwitchPrior final : public ceres::SizedCostFunction<1, 1> {
 public:
  explicit SwitchPrior(double weight) : weight_(weight) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    residuals[0] = weight_ * (1.0 - parameters[0][0]);
    if (jacobians != nullptr && jacobians[0] != nullptr) jacobians[0][0] = -weight_;
    return true;
  }

 private:
  double weight_;
};

}  // namespace

template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakeSwitchableFactor(const PoseEdge<Pose>& edge,
                                                          RotationError rotation_error) {
  return std::make_unique<SwitchableFactor<Pose>>(edge, rotation_error);
}

std::unique_ptr<ceres::CostFunction> MakeSwitchPrior(double weight) {
  return std::make_unique<SwitchPrior>(weight);
}

template std::unique_ptr<ceres::CostFunction> MakeSwitchableFactor(const PoseEdge<Pose2>&, RotationError);
template std::unique_ptr<ceres::CostFunction> MakeSwitchableFactor(const PoseEdge<Pose3>&, RotationError);

}  // namespace ariadne::slam
