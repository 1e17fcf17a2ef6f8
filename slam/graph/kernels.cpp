#include "slam/graph/kernels.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

KernelValue Huber(double s, double c) {
  if (s <= c) return {s, 1.0, 0.0};
  const double weight = std::sqrt(c / s);
  return {2.0 * std::sqrt(c * s) - c, weight, -0.5 * weight / s};
}

KernelValue Cauchy(double s, double c) {
  const double weight = 1.0 / (1.0 + s / c);
  return {c * std::log1p(s / c), weight, -weight * weight / c};
}

KernelValue GemanMcClure(double s, double c) {
  const double share = 1.0 / (1.0 + s / c);
  return {s * share, share * share, -2.0 * share * share * share / c};
}

KernelValue DynamicCovarianceScaling(double s, double c) {
  if (s <= c) return {s, 1.0, 0.0};
  const double scale = 2.0 / (1.0 + s / c);
  return {0.5 * scale * (3.0 * s - c), scale * scale, -scale * scale * scale / c};
}

}  // namespace

KernelValue Evaluate(GraphRobust kernel, double squared_error, double squared_scale) {
  switch (kernel) {
    case GraphRobust::kNone:
      break;
    case GraphRobust::kHuber:
      return Huber(squared_error, squared_scale);
    case GraphRobust::kCauchy:
      return Cauchy(squared_error, squared_scale);
    case GraphRobust::kGemanMcClure:
    case GraphRobust::kSwitchable:
      return GemanMcClure(squared_error, squared_scale);
    case GraphRobust::kDcs:
      return DynamicCovarianceScaling(squared_error, squared_scale);
    case GraphRobust::kGnc:
      if (squared_error > squared_scale) return {squared_scale, 0.0, 0.0};
  }
  return {squared_error, 1.0, 0.0};
}

double SquaredScale(double confidence, int dof) {
  if (!(confidence > 0.0 && confidence < 1.0) || dof < 1)
    Fail("no chi-square quantile of {} with {} degrees of freedom", confidence, dof);
  return boost::math::quantile(boost::math::chi_squared(dof), confidence);
}

}  // namespace ariadne::slam
