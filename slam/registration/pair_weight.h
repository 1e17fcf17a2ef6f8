#pragma once

#include <limits>
#include <vector>

#include "slam/registration/options.h"

namespace ariadne::slam {

/// How strongly a pair counts in one iteration: a function of its squared residual alone.
struct PairWeight {
  double max_squared_residual =
      std::numeric_limits<double>::infinity();  // above it the pair is trimmed [m^2]
  RobustKernel kernel = RobustKernel::kNone;
  double squared_scale = 1.0;  // [m^2]

  double operator()(double squared_residual) const {
    if (squared_residual > max_squared_residual) return 0.0;
    return kernel == RobustKernel::kNone ? 1.0 : KernelWeight(squared_residual);
  }
  /// The derivative by the squared residual [1/m^2].
  double Derivative(double squared_residual) const;

 private:
  double KernelWeight(double squared_residual) const;
};

/// Sets the trimming threshold (the share of residuals to keep) and the kernel's scale [m]: as given, or,
/// for 0, three robust sigmas of the residuals. The residuals are only needed for what depends on them.
PairWeight ChooseWeight(std::vector<double> squared_residuals, double trim, RobustKernel kernel,
                        double scale);

}  // namespace ariadne::slam
