#include "control/resample_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

double StepBetween(const Pose2& a, const Pose2& b) { return (a.Inverse() * b).Log().norm(); }

TEST(ResamplePath, GivesTenValuesPerMeter) {
  const ApproachResult straight = SimulateApproach({0.0, {-5.0, 0.0}}, {}, {});
  const std::vector<Pose2> poses = ResamplePath(straight.samples, {});
  EXPECT_EQ(poses.size(), static_cast<std::size_t>(std::ceil(10.0 * straight.length)) + 1);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    EXPECT_NEAR((poses[k].translation - poses[k - 1].translation).norm(),
                straight.length / static_cast<double>(poses.size() - 1), 1e-9);
  }
}

TEST(ResamplePath, FollowsTheArcs) {
  // A quarter of a circle of 2 m in a single sample.
  const double time = 4.0;
  const DriveCommand command{M_PI / time, 0.5 * M_PI / time};
  const Pose2 end = Pose2::Exp({M_PI, 0.0, 0.5 * M_PI});
  const std::vector<ApproachSample> samples{{0.0, {}, command}, {time, end, {}}};
  const std::vector<Pose2> poses = ResamplePath(samples, {10.0, 0.0});
  ASSERT_EQ(poses.size(), 33u);  // of 31.4 intervals
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double angle = 0.5 * M_PI * static_cast<double>(k) / 32.0;
    EXPECT_LT(StepBetween(poses[k], {angle, {2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle)}}), 1e-9);
  }
}

TEST(ResamplePath, StepsAreSmallEnoughAlsoInTurns) {
  const ApproachResult result = SimulateApproach({2.0, {-3.0, 1.0}}, {2.5, {1.0, 2.0}}, {});
  const std::vector<Pose2> poses = ResamplePath(result.samples, {});
  EXPECT_EQ(StepBetween(poses.front(), result.samples.front().T_map_robot), 0.0);
  EXPECT_EQ(StepBetween(poses.back(), result.samples.back().T_map_robot), 0.0);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Pose2 step = poses[k - 1].Inverse() * poses[k];
    EXPECT_LE(10.0 * step.translation.norm() + 10.0 * std::abs(step.angle), 1.0 + 1e-6);
  }
  EXPECT_EQ(poses.size(), static_cast<std::size_t>(std::ceil(10.0 * (result.length + result.turned))) + 1);
}

TEST(ResamplePath, OfATurnInPlace) {
  const ApproachResult turn = SimulateApproach({2.0, {0.0, 0.0}}, {}, {});
  EXPECT_EQ(ResamplePath(turn.samples, {}).size(), 21u);
  EXPECT_EQ(ResamplePath(turn.samples, {10.0, 0.0}).size(), 1u) << "the paper's";
}

TEST(ResamplePath, OfNoMotionIsOnePose) {
  EXPECT_EQ(ResamplePath({{0.0, {1.0, {2.0, 3.0}}, {}}}, {}).size(), 1u);
  EXPECT_EQ(ErrorOf([] { ResamplePath({}, {}); }), "a path without a pose cannot be sampled");
  EXPECT_NE(ErrorOf([] {
              ResamplePath({ApproachSample{}}, {0.0, 10.0});
            }).find("sampling.per_meter"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::control
