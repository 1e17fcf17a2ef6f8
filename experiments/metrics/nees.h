#pragma once

#include <cstddef>
#include <span>

#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// Normalized estimation error squared: tau^T C^-1 tau, where T_true = T_estimate * Exp(tau) in the tangent
/// of Pose3 (translation first, perturbed on the right, so C is in the laser's frame). For an honest
/// covariance C and a Gaussian error it follows chi^2 with 6 degrees of freedom.
/// C must be positive definite: a pose that the surfaces do not hold in all directions has no NEES.
double Nees(const slam::Pose3& T_map_laser, const slam::Pose3& T_map_laser_true,
            const slam::Pose3::Square& covariance);

/// x with P(chi^2 <= x) = p.
double ChiSquareQuantile(double p, double degrees_of_freedom);

/// Where the mean of `count` independent NEES lies with the given probability, both tails being equal:
/// quantiles of chi^2 with count * dof degrees of freedom, divided by count (Bar-Shalom, Li, Kirubarajan,
/// Estimation with Applications to Tracking and Navigation, 2001, 5.4.2).
struct NeesBand {
  double low = 0.0;
  double high = 0.0;

  bool contains(double mean) const { return low <= mean && mean <= high; }
};

NeesBand MeanNeesBand(std::size_t count, double confidence = 0.95, int dof = slam::Pose3::kDof);

/// The verdict on the covariances of many estimates with independent errors.
struct NeesSummary {
  std::size_t count = 0;
  double mean = 0.0;  // dof if honest; more: the covariances are too small
  NeesBand band;      // of the mean
  double share_within =
      0.0;  // share below the `confidence` quantile of one NEES: `confidence` itself if honest
};

NeesSummary SummarizeNees(std::span<const double> nees, double confidence = 0.95,
                          int dof = slam::Pose3::kDof);

}  // namespace ariadne::experiments
