#include "experiments/metrics/nees.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

#include "experiments/metrics/statistics.h"
#include "slam/base/error.h"

namespace ariadne::experiments {

double Nees(const slam::Pose3& T_map_laser, const slam::Pose3& T_map_laser_true,
            const slam::Pose3::Square& covariance) {
  const Eigen::LLT<slam::Pose3::Square> factor(covariance);
  if (!covariance.allFinite() || factor.info() != Eigen::Success)
    Fail("the covariance of a pose is not positive definite: its NEES is not defined");
  const slam::Pose3::Tangent tau = (T_map_laser.Inverse() * T_map_laser_true).Log();
  return tau.dot(factor.solve(tau));
}

double ChiSquareQuantile(double p, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::chi_squared(degrees_of_freedom), p);
}

NeesBand MeanNeesBand(std::size_t count, double confidence, int dof) {
  if (count == 0) Fail("the mean of no NEES has no band");
  const auto n = static_cast<double>(count);
  const double tail = 0.5 * (1.0 - confidence);
  return {ChiSquareQuantile(tail, n * dof) / n, ChiSquareQuantile(1.0 - tail, n * dof) / n};
}

NeesSummary SummarizeNees(std::span<const double> nees, double confidence, int dof) {
  const double limit = ChiSquareQuantile(confidence, dof);
  const auto within = std::count_if(nees.begin(), nees.end(), [&](double x) { return x <= limit; });
  return {nees.size(), Mean(nees), MeanNeesBand(nees.size(), confidence, dof),
          static_cast<double>(within) / static_cast<double>(nees.size())};
}

}  // namespace ariadne::experiments
