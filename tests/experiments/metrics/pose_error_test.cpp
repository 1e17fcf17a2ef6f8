#include "experiments/metrics/pose_error.h"

#include <gtest/gtest.h>

#include "slam/geometry/so3.h"

namespace ariadne::experiments {
namespace {

using slam::Pose3;

Pose3 At(double x, double y, double yaw = 0.0) { return {slam::ExpSo3({0.0, 0.0, yaw}), {x, y, 0.0}}; }

TEST(MeasurePoseErrors, IsZeroForTheTruth) {
  const std::vector<Pose3> poses{At(0, 0), At(1, 2, 0.3), At(2, 5, -0.7)};
  const PoseErrors errors = MeasurePoseErrors(poses, poses);
  EXPECT_NEAR(errors.translation_max, 0.0, 1e-15);
  EXPECT_NEAR(errors.rotation_max, 0.0, 1e-7);
}

TEST(MeasurePoseErrors, TakesTheRmsOverAllPosesButTheFirst) {
  const std::vector<Pose3> truth{At(0, 0), At(1, 0), At(2, 0)};
  const std::vector<Pose3> poses{At(0, 0), At(1, 0.3, 0.01), At(2.4, 0, -0.07)};
  const PoseErrors errors = MeasurePoseErrors(poses, truth);
  EXPECT_NEAR(errors.translation_rms, std::sqrt((0.09 + 0.16) / 2.0), 1e-12);
  EXPECT_NEAR(errors.translation_max, 0.4, 1e-12);
  EXPECT_NEAR(errors.rotation_rms, 0.05, 1e-9) << "sqrt((0.01^2 + 0.07^2) / 2)";
  EXPECT_NEAR(errors.rotation_max, 0.07, 1e-9);
}

TEST(MeasurePoseErrors, DoesNotDependOnTheFrameOfEither) {
  const std::vector<Pose3> truth{At(0, 0), At(1, 0), At(2, 0)};
  const std::vector<Pose3> poses{At(0, 0), At(1, 0.3), At(2.4, 0)};
  const PoseErrors expected = MeasurePoseErrors(poses, truth);
  const Pose3 T_other_map{slam::ExpSo3({0.3, -0.8, 2.0}), {10.0, -20.0, 3.0}};
  std::vector<Pose3> moved;
  for (const Pose3& pose : poses) moved.push_back(T_other_map * pose);
  const PoseErrors errors = MeasurePoseErrors(moved, truth);
  EXPECT_NEAR(errors.translation_rms, expected.translation_rms, 1e-12);
  EXPECT_NEAR(errors.translation_max, expected.translation_max, 1e-12);
}

TEST(MeasurePoseErrors, LetsAnErrorOfTheFirstHeadingGrowWithTheDistance) {
  // Without alignment: a master that is turned by 0.1 rad puts a pose 10 m away off by the chord.
  const std::vector<Pose3> truth{At(0, 0), At(10, 0)};
  const std::vector<Pose3> poses{At(0, 0, 0.1), At(10, 0)};
  const PoseErrors errors = MeasurePoseErrors(poses, truth);
  EXPECT_NEAR(errors.translation_max, 20.0 * std::sin(0.05), 1e-12);
  EXPECT_NEAR(errors.rotation_max, 0.1, 1e-9);
}

TEST(MeasurePoseErrors, HasNothingToMeasureOnTheMasterAlone) {
  EXPECT_EQ(MeasurePoseErrors({}, {}).translation_rms, 0.0);
  EXPECT_EQ(MeasurePoseErrors({At(1, 2)}, {At(5, 6)}).translation_max, 0.0);
}

}  // namespace
}  // namespace ariadne::experiments
