#include "experiments/metrics/nees.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <vector>

#include "slam/base/error.h"
#include "tests/support/random_geometry.h"

namespace ariadne::experiments {
namespace {

using slam::Pose3;

TEST(ChiSquareQuantile, HasThePublishedValues) {
  EXPECT_NEAR(ChiSquareQuantile(0.95, 1), 3.841, 5e-4);
  EXPECT_NEAR(ChiSquareQuantile(0.95, 6), 12.591587243743977, 1e-10);
  EXPECT_NEAR(ChiSquareQuantile(0.025, 300), 253.91232260248975, 1e-9);
}

TEST(MeanNeesBand, IsThatOfTheSumDividedByTheCount) {
  const NeesBand band = MeanNeesBand(50);  // 300 degrees of freedom
  EXPECT_NEAR(band.low, 253.91232260248975 / 50.0, 1e-10);
  EXPECT_NEAR(band.high, 349.87446882991526 / 50.0, 1e-10);
  EXPECT_TRUE(band.contains(6.0));
  EXPECT_FALSE(band.contains(5.0));
  EXPECT_FALSE(band.contains(7.0));
  EXPECT_THROW(MeanNeesBand(0), Error);
}

TEST(Nees, WeighsTheErrorInTheFrameOfTheLaser) {
  // 3 cm along the laser's x, which is the map's y, at sigma 1 cm there, and 2 deg at sigma 1 deg about z.
  const Pose3 T_map_laser{slam::ExpSo3({0.0, 0.0, std::numbers::pi / 2.0}), {1.0, 2.0, 0.0}};
  const Pose3 moved{T_map_laser.rotation, {1.0, 2.03, 0.0}};
  const Pose3 turned{T_map_laser.rotation * slam::ExpSo3({0.0, 0.0, 0.02}), {1.0, 2.0, 0.0}};
  Pose3::Tangent sigma;
  sigma << 0.01, 0.1, 0.1, 0.1, 0.1, 0.01;
  const Pose3::Square covariance = sigma.cwiseAbs2().asDiagonal();
  EXPECT_NEAR(Nees(T_map_laser, moved, covariance), 9.0, 1e-9);
  EXPECT_NEAR(Nees(T_map_laser, turned, covariance), 4.0, 1e-9);
}

TEST(Nees, NeedsACovarianceOfAllDirections) {
  Pose3::Square covariance = Pose3::Square::Identity();
  covariance(2, 2) = 0.0;
  EXPECT_THROW(Nees({}, {}, covariance), Error);
  covariance(2, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Nees({}, {}, covariance), Error);
}

/// NEES of `count` poses with errors drawn from a covariance, judged with the covariance times `claimed`.
NeesSummary Simulate(int count, double claimed) {
  RandomStream stream = NamedStream(7, "nees_test");
  Pose3::Square root = Pose3::Square::Zero();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j <= i; ++j) root(i, j) = 0.01 * DrawNormal(stream, i == j ? 2.0 : 0.0, 0.3);
  }
  std::vector<double> nees;
  for (int k = 0; k < count; ++k) {
    Pose3::Tangent z;
    for (double& x : z) x = DrawNormal(stream, 0.0, 1.0);
    const Pose3 estimate = slam::DrawMotion(stream, 10.0, 3.0);
    nees.push_back(Nees(estimate, estimate * Pose3::Exp(root * z), claimed * root * root.transpose()));
  }
  return SummarizeNees(nees);
}

TEST(SummarizeNees, AcceptsAnHonestCovariance) {
  const NeesSummary s = Simulate(2000, 1.0);
  EXPECT_EQ(s.count, 2000u);
  EXPECT_TRUE(s.band.contains(s.mean)) << s.mean;
  EXPECT_NEAR(s.share_within, 0.95, 0.015);  // 3 sigma
}

TEST(SummarizeNees, SeesOneThatIsTooSmallOrTooLarge) {
  const NeesSummary certain = Simulate(200, 0.7), modest = Simulate(200, 1.4);
  EXPECT_GT(certain.mean, certain.band.high);
  EXPECT_LT(certain.share_within, 0.93);
  EXPECT_LT(modest.mean, modest.band.low);
}

}  // namespace
}  // namespace ariadne::experiments
