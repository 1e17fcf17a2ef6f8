// The promise on noisy, partly overlapping clouds: from up to 1 m and 15 degrees away the pose is found,
// and it is as certain as the covariance says. Slow: 200 alignments of 5000 points.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "slam/registration/align.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kSeeds = 200;

AlignOptions RecoveryOptions() {
  AlignOptions options;
  options.metric = Metric::kPlaneToPlane;
  options.kernel = RobustKernel::kCauchy;  // for the outliers
  options.search_radius = 1.0;
  options.start_distance = 0.3;
  options.max_distance = 0.15;
  options.convergence_rms = 1e-6;
  return options;
}

struct Outcome {
  bool recovered = false;       // the right minimum: 5 cm and 1 degree
  bool within_3_sigma = false;  // and in all six components where the covariance says
  double nees = 0.0;            // error^T covariance^-1 error
};

Outcome Recover(std::uint64_t seed) {
  const TwoClouds clouds = DrawTwoClouds(seed);
  const AlignResult result = Align(clouds.model, clouds.data, clouds.T_model_data_guess, RecoveryOptions());
  if (!result.converged()) return {};
  const Eigen::Vector3d center = CentroidOf(clouds.data.positions);
  const double distance = (result.T_model_data * center - clouds.T_model_data * center).norm();
  const double angle = RotationDistance(result.T_model_data, clouds.T_model_data);

  const Pose3::Tangent error = (result.T_model_data.Inverse() * clouds.T_model_data).Log();
  const Pose3::Square& covariance = result.assessment->covariance;
  Outcome outcome;
  outcome.recovered = distance < 0.05 && angle < RadFromDeg(1.0);
  const auto sigmas = covariance.diagonal().array().sqrt();
  outcome.within_3_sigma = outcome.recovered && (error.array().abs() <= 3.0 * sigmas).all();
  outcome.nees = error.dot(covariance.ldlt().solve(error));
  return outcome;
}

TEST(AlignRecovery, IsWithinThreeSigmaOfAnHonestCovariance) {
  std::vector<Outcome> outcomes(kSeeds);
  Parallel(2).For(kSeeds, 1,
                  [&](std::size_t seed, std::size_t, std::size_t) { outcomes[seed] = Recover(seed); });
  const auto recovered = std::ranges::count_if(outcomes, &Outcome::recovered);
  const auto within = std::ranges::count_if(outcomes, &Outcome::within_3_sigma);
  double nees = 0.0;
  for (const Outcome& outcome : outcomes) nees += outcome.recovered ? outcome.nees : 0.0;
  nees /= static_cast<double>(recovered);
  RecordProperty("recovered", std::to_string(recovered));
  RecordProperty("within_3_sigma", std::to_string(within));
  RecordProperty("mean_nees", std::to_string(nees));
  std::cout << "recovered " << recovered << ", within 3 sigma " << within << " of " << kSeeds
            << ", mean NEES " << nees << " (ideal 6)\n";

  EXPECT_GE(within, kSeeds * 95 / 100);
  // The mean of 200 squared errors of six exactly normalized components is 6 +- 0.24 (one sigma). Below
  // three of these, the covariance would be too large. It is a little too small, since it knows the scatter
  // of the errors, but not the bias of pairs at the end of the overlap; the bound is sigmas 20 % too small.
  EXPECT_GT(nees, 6.0 - 3.0 * std::sqrt(12.0 / kSeeds));
  EXPECT_LT(nees, 6.0 * 1.2 * 1.2);
}

}  // namespace
}  // namespace ariadne::slam
