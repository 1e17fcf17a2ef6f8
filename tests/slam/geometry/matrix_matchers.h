#pragma once

#include <gmock/gmock.h>

#include <Eigen/Core>

namespace ariadne::slam {

MATCHER_P2(NearPlainMatrix, expected, tolerance, "") {
  const auto difference = (arg.template cast<long double>() - expected).eval();
  const auto worst = static_cast<double>(difference.cwiseAbs().maxCoeff());
  *result_listener << "\nworst difference " << worst;
  return difference.allFinite() && worst <= tolerance;
}

/// Every entry within `tolerance` of the expected one, and none NaN.
template <typename Derived>
auto NearMatrix(const Eigen::MatrixBase<Derived>& expected, double tolerance) {
  return NearPlainMatrix(expected.template cast<long double>().eval(), tolerance);
}

}  // namespace ariadne::slam
