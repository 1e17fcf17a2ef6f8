#pragma once

#include <ceres/loss_function.h>

#include "slam/graph/kernels.h"

namespace ariadne::slam {

/// A robust kernel (kernels.h) as Ceres takes it. One kernel may serve many factors.
class KernelLoss final : public ceres::LossFunction {
 public:
  KernelLoss(GraphRobust kernel, double squared_scale) : kernel_(kernel), squared_scale_(squared_scale) {}

  void Evaluate(double squared_error, double rho[3]) const override {
    const KernelValue value = slam::Evaluate(kernel_, squared_error, squared_scale_);
    rho[0] = value.value;
    rho[1] = value.slope;
    rho[2] = value.curvature;
  }

 private:
  GraphRobust kernel_;
  double squared_scale_;
};

}  // namespace ariadne::slam
