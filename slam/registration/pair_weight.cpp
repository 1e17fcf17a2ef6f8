#include "slam/registration/pair_weight.h"

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

/// The q-quantile; reorders the values.
double Quantile(std::vector<double>& values, double q) {
  const double rank = q * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::llround(rank));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double PairWeight::KernelWeight(double squared_residual) const {
  const double u = squared_residual / squared_scale;
  switch (kernel) {
    case RobustKernel::kNone:
      return 1.0;
    case RobustKernel::kHuber:
      return u <= 1.0 ? 1.0 : 1.0 / std::sqrt(u);
    case RobustKernel::kCauchy:
      return 1.0 / (1.0 + u);
    case RobustKernel::kTukey:
      return u < 1.0 ? (1.0 - u) * (1.0 - u) : 0.0;
    case RobustKernel::kGemanMcClure:
      return 1.0 / ((1.0 + u) * (1.0 + u));
  }
  return 1.0;
}

double PairWeight::Derivative(double squared_residual) const {
  if (squared_residual > max_squared_residual) return 0.0;
  const double u = squared_residual / squared_scale;
  switch (kernel) {
    case RobustKernel::kNone:
      return 0.0;
    case RobustKernel::kHuber:
      return u <= 1.0 ? 0.0 : -0.5 / (u * std::sqrt(u) * squared_scale);
    case RobustKernel::kCauchy:
      return -1.0 / ((1.0 + u) * (1.0 + u) * squared_scale);
    case RobustKernel::kTukey:
      return u < 1.0 ? -2.0 * (1.0 - u) / squared_scale : 0.0;
    case RobustKernel::kGemanMcClure:
      return -2.0 / ((1.0 + u) * (1.0 + u) * (1.0 + u) * squared_scale);
  }
  return 0.0;
}

PairWeight ChooseWeight(std::vector<double> squared_residuals, double trim, RobustKernel kernel,
                        double scale) {
  PairWeight weight;
  weight.kernel = kernel;
  weight.squared_scale = scale * scale;
  if (squared_residuals.empty()) return weight;
  if (trim < 1.0) weight.max_squared_residual = Quantile(squared_residuals, trim);
  if (kernel != RobustKernel::kNone && scale == 0.0) {
    // 1.4826 median |r| is sigma for normal residuals. Residuals of (nearly) zero leave nothing to weigh
    // down; the floor, a micrometre, only keeps the division defined.
    const double sigma = 1.4826 * std::sqrt(Quantile(squared_residuals, 0.5));
    weight.squared_scale = std::pow(std::max(3.0 * sigma, 1e-6), 2);
  }
  return weight;
}

}  // namespace ariadne::slam
