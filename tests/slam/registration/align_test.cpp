#include "slam/registration/align.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/slam/registration/same_result.h"
#include "tests/support/error_of.h"
#include "tests/support/two_clouds.h"

namespace ariadne::slam {
namespace {

/// Two clouds whose start is a little off, so that every metric converges.
TwoClouds EasyClouds(std::size_t points = 1500) {
  return DrawTwoClouds(1,
                       {.points = points, .outliers = 0.05, .start_translation = 0.2, .start_angle = 4.0});
}

AlignResult AlignClouds(const TwoClouds& clouds, const AlignOptions& options) {
  return Align(clouds.model, clouds.data, clouds.T_model_data_guess, options);
}

class AlignBy : public testing::TestWithParam<Metric> {
 protected:
  AlignBy() { options_.metric = GetParam(); }
  AlignOptions options_;
};
INSTANTIATE_TEST_SUITE_P(Metrics, AlignBy,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(AlignBy, FindsThePose) {
  const TwoClouds clouds = EasyClouds();
  options_.max_distance = 0.2;
  options_.start_distance = 0.5;
  const AlignResult result = AlignClouds(clouds, options_);
  ASSERT_TRUE(result.converged()) << result.message;
  const Eigen::Vector3d center = CentroidOf(clouds.data.positions);
  const double tolerance = GetParam() == Metric::kPointToPoint ? 0.05 : 0.01;  // [m]
  EXPECT_LT((result.T_model_data * center - clouds.T_model_data * center).norm(), tolerance);
  EXPECT_LT(RotationDistance(result.T_model_data, clouds.T_model_data), tolerance);
  EXPECT_GT(result.overlap, 0.4);
  EXPECT_LT(result.overlap, 0.7) << "60 % have a counterpart";
  EXPECT_LT(result.rms, 0.15);
}

TEST_P(AlignBy, FindsTheSameByBruteForceAndByKdTree) {
  const TwoClouds clouds = EasyClouds();
  const AlignResult by_tree = AlignClouds(clouds, options_);
  options_.search = Search::kBruteForce;
  const AlignResult by_brute_force = AlignClouds(clouds, options_);
  EXPECT_TRUE(by_tree.converged()) << by_tree.message;
  EXPECT_THAT(by_brute_force.T_model_data, NearPose(by_tree.T_model_data, 1e-12));
  ExpectSameBytes(by_brute_force, by_tree);  // more than was asked for: identical pairs make it so
}

TEST_P(AlignBy, HasTheSameBytesOnAnyNumberOfThreads) {
  const TwoClouds clouds = EasyClouds();
  options_.kernel = RobustKernel::kCauchy;
  options_.search_radius = 0.4;
  options_.start_distance = 0.8;
  const AlignResult serial = AlignClouds(clouds, options_);
  for (const int threads : {2, 3}) {
    options_.threads = threads;
    ExpectSameBytes(AlignClouds(clouds, options_), serial);
  }
}

TEST_P(AlignBy, ReportsEachIteration) {
  const TwoClouds clouds = EasyClouds();
  options_.start_distance = 1.0;
  options_.shrink = 0.5;
  std::vector<AlignIteration> seen;
  const AlignResult result = Align(PrepareModel(clouds.model, options_), PrepareData(clouds.data, options_),
                                   clouds.T_model_data_guess, options_,
                                   [&](const AlignIteration& iteration) { seen.push_back(iteration); });
  ASSERT_EQ(seen.size(), result.iterations.size());
  ASSERT_GT(seen.size(), 3u);
  EXPECT_EQ(seen[0].max_distance, 1.0);
  EXPECT_EQ(seen[1].max_distance, 0.5);
  EXPECT_EQ(seen[2].max_distance, 0.5) << "not below max_distance";
  EXPECT_EQ(seen.back().pairs, result.pairs);
  EXPECT_EQ(seen.back().rms, result.rms);
  EXPECT_LT(seen.back().step_translation, seen.front().step_translation);
  EXPECT_DOUBLE_EQ(result.overlap, static_cast<double>(result.pairs) / 1500.0);
  EXPECT_THAT(result.message,
              testing::StartsWith("converged after " + std::to_string(seen.size()) + " iterations"));
}

TEST_P(AlignBy, ChangesNothingAtItsOwnResult) {
  const TwoClouds clouds = EasyClouds();
  options_.convergence_rms = 0.0;
  const AlignResult first = AlignClouds(clouds, options_);
  const AlignResult again = Align(clouds.model, clouds.data, first.T_model_data, options_);
  ASSERT_TRUE(again.converged());
  EXPECT_THAT(again.T_model_data, NearPose(first.T_model_data, 1e-9));
}

TEST_P(AlignBy, StopsAtTheLimitOfIterationsWithoutClaimingSuccess) {
  options_.max_iterations = 3;
  const AlignResult result = AlignClouds(EasyClouds(), options_);
  EXPECT_EQ(result.status, AlignStatus::kIterationLimit);
  EXPECT_EQ(result.message, "not converged after 3 iterations");
  EXPECT_EQ(result.iterations.size(), 3u);
  EXPECT_FALSE(result.assessment.has_value());
}

TEST_P(AlignBy, StopsAfterAShortStepWhereThatIsAskedFor) {
  const TwoClouds clouds = EasyClouds();
  options_.convergence_step = 0.003;
  const AlignResult result = AlignClouds(clouds, options_);
  ASSERT_TRUE(result.converged());
  const AlignIteration& last = result.iterations.back();
  EXPECT_LT(std::max(last.step_translation, last.step_rotation), 0.003);
  for (std::size_t k = 0; k + 1 < result.iterations.size(); ++k) {
    const AlignIteration& other = result.iterations[k];
    EXPECT_GE(std::max(other.step_translation, other.step_rotation), 0.003) << k;
  }
}

TEST_P(AlignBy, AssessesOnlyWhereAsked) {
  const TwoClouds clouds = EasyClouds();
  const AlignResult assessed = AlignClouds(clouds, options_);
  ASSERT_TRUE(assessed.assessment.has_value());
  EXPECT_GT(assessed.assessment->covariance.diagonal().minCoeff(), 0.0);
  options_.assess = false;
  const AlignResult plain = AlignClouds(clouds, options_);
  EXPECT_FALSE(plain.assessment.has_value());
  EXPECT_EQ(plain.T_model_data.translation, assessed.T_model_data.translation);
}

TEST(Align, FindsTheSameByQuaternionAndBySvd) {
  AlignOptions options;
  const AlignResult by_quaternion = AlignClouds(EasyClouds(), options);
  options.closed_form = ClosedForm::kSvd;
  const AlignResult by_svd = AlignClouds(EasyClouds(), options);
  EXPECT_EQ(by_svd.iterations.size(), by_quaternion.iterations.size());
  EXPECT_EQ(by_svd.pairs, by_quaternion.pairs);
  EXPECT_THAT(by_svd.T_model_data, NearPose(by_quaternion.T_model_data, 1e-10));
}

TEST(Align, EndsInALimitCycle) {
  // So sparse that pairs come and go for ever: each of the last poses is one of those before.
  int cycles = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TwoClouds clouds =
        DrawTwoClouds(seed, {.points = 400, .start_translation = 0.2, .start_angle = 3.0});
    AlignOptions options;
    options.metric = Metric::kPointToPlane;
    options.convergence_rms = 0.0;
    const AlignResult result = AlignClouds(clouds, options);
    EXPECT_NE(result.status, AlignStatus::kIterationLimit) << result.message;
    if (result.iterations.back().step_translation < 1e-3) continue;
    EXPECT_THAT(result.message, testing::EndsWith("in a cycle"));
    ++cycles;
  }
  EXPECT_GT(cycles, 2);
}

TEST(Align, NamesTheOptionThatIsOutOfRange) {
  const TwoClouds clouds = EasyClouds(100);
  const auto sentence = [&](auto member, auto value, Metric metric) {
    AlignOptions options;
    options.metric = metric;
    options.*member = value;
    return ErrorOf([&] { AlignClouds(clouds, options); });
  };
  for (const Metric metric : {Metric::kPointToPoint, Metric::kPlaneToPlane}) {
    EXPECT_EQ(sentence(&AlignOptions::max_distance, 0.0, metric),
              "icp.max_distance is 0 m, but must be in 0.0001 to 1000");
    EXPECT_EQ(sentence(&AlignOptions::trim, std::nan(""), metric),
              "icp.trim is nan , but must be in 0.05 to 1");
    for (const auto& [member, key] : {std::pair(&AlignOptions::search_radius, "search_radius"),
                                      {&AlignOptions::start_distance, "start_distance"},
                                      {&AlignOptions::shrink, "shrink"},
                                      {&AlignOptions::kernel_scale, "kernel_scale"},
                                      {&AlignOptions::convergence_rms, "convergence_rms"},
                                      {&AlignOptions::convergence_step, "convergence_step"},
                                      {&AlignOptions::min_observability, "min_observability"}}) {
      EXPECT_THAT(sentence(member, -1.0, metric),
                  testing::StartsWith(std::string("icp.") + key + " is -1 "));
    }
    for (const auto& [member, key] : {std::pair(&AlignOptions::threads, "threads"),
                                      {&AlignOptions::max_iterations, "max_iterations"},
                                      {&AlignOptions::min_pairs, "min_pairs"},
                                      {&AlignOptions::normal_neighbors, "normal_neighbors"}}) {
      EXPECT_THAT(sentence(member, 0, metric), testing::StartsWith(std::string("icp.") + key + " is 0 "));
    }
  }
}

TEST(AlignStatus, HasNames) {
  EXPECT_EQ(Name(AlignStatus::kConverged), "converged");
  EXPECT_EQ(Name(AlignStatus::kBadInput), "bad input");
}

}  // namespace
}  // namespace ariadne::slam
