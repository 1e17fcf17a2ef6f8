// Trimming, kernels and the filter of boundaries, against points that have no true counterpart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "slam/registration/align.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

double ErrorAgainstTruth(const AlignResult& result, const TwoClouds& clouds) {
  const Eigen::Vector3d center = CentroidOf(clouds.data.positions);
  return (result.T_model_data * center - clouds.T_model_data * center).norm();
}

/// The mean error over a few rooms with many outliers, for one set of options.
double MeanError(const AlignOptions& options) {
  constexpr std::uint64_t kRooms = 6;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    const TwoClouds clouds = DrawTwoClouds(
        seed, {.points = 1500, .outliers = 0.3, .start_translation = 0.1, .start_angle = 2.0});
    const AlignResult result = Align(clouds.model, clouds.data, clouds.T_model_data_guess, options);
    EXPECT_TRUE(result.converged()) << result.message;
    sum += ErrorAgainstTruth(result, clouds);
  }
  return sum / kRooms;
}

AlignOptions PlainOptions() {
  AlignOptions options;
  options.metric = Metric::kPointToPlane;
  options.max_distance = 0.6;
  return options;
}

TEST(AlignRobust, IsMoreThanHalfABiasWithoutRobustness) {
  EXPECT_GT(MeanError(PlainOptions()), 0.02) << "else the tests below would show nothing";
}

class AlignWithKernel : public testing::TestWithParam<RobustKernel> {};
INSTANTIATE_TEST_SUITE_P(Kernels, AlignWithKernel,
                         testing::Values(RobustKernel::kHuber, RobustKernel::kCauchy, RobustKernel::kTukey,
                                         RobustKernel::kGemanMcClure),
                         [](const auto& kernel) { return std::string(ariadne::NameOf(kernel.param)); });

TEST_P(AlignWithKernel, HasLessThanHalfOfTheErrorWithoutIt) {
  AlignOptions options = PlainOptions();
  options.kernel = GetParam();
  EXPECT_LT(MeanError(options), 0.5 * MeanError(PlainOptions()));
}

TEST_P(AlignWithKernel, HasItAlsoWithAScaleOfItsOwn) {
  AlignOptions options = PlainOptions();
  options.kernel = GetParam();
  options.kernel_scale = 0.05;
  EXPECT_LT(MeanError(options), 0.5 * MeanError(PlainOptions()));
}

TEST(AlignRobust, IsTrimmingToo) {
  AlignOptions options = PlainOptions();
  options.trim = 0.6;
  EXPECT_LT(MeanError(options), 0.5 * MeanError(PlainOptions()));
}

TEST(AlignRobust, CountsOnlyTheTrimmedShareAsPairs) {
  const TwoClouds clouds = DrawTwoClouds(1, {.points = 1000, .start_translation = 0.1, .start_angle = 2.0});
  AlignOptions options;
  options.max_iterations = 1;
  const double all = static_cast<double>(
      Align(clouds.model, clouds.data, clouds.T_model_data_guess, options).iterations[0].pairs);
  options.trim = 0.4;
  const AlignResult trimmed = Align(clouds.model, clouds.data, clouds.T_model_data_guess, options);
  EXPECT_NEAR(static_cast<double>(trimmed.iterations[0].pairs), 0.4 * all, 1.0);
}

TEST(AlignRobust, DropsPairsAtTheEndOfTheModel) {
  // Most of the data lies beyond the model, and all of that pairs with the model's last points.
  AlignOptions options;
  options.max_distance = 0.6;
  double with = 0.0, without = 0.0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const TwoClouds clouds = DrawTwoClouds(
        seed,
        {.points = 3000, .overlap = 0.5, .outliers = 0.0, .start_translation = 0.1, .start_angle = 2.0});
    options.skip_boundary = false;
    without +=
        ErrorAgainstTruth(Align(clouds.model, clouds.data, clouds.T_model_data_guess, options), clouds);
    options.skip_boundary = true;
    with += ErrorAgainstTruth(Align(clouds.model, clouds.data, clouds.T_model_data_guess, options), clouds);
  }
  EXPECT_LT(with, 0.7 * without);
}

}  // namespace
}  // namespace ariadne::slam
