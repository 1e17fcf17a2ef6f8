#include "experiments/metrics/trajectory_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/error.h"
#include "slam/geometry/so3.h"

namespace ariadne::experiments {
namespace {

using slam::Pose3;

Pose3 At(double x, double y, double yaw = 0.0) { return {slam::ExpSo3({0.0, 0.0, yaw}), {x, y, 0.0}}; }

Trajectory Moved(const Pose3& T_other_map, const Trajectory& poses) {
  Trajectory moved;
  for (const Pose3& pose : poses) moved.push_back(T_other_map * pose);
  return moved;
}

const Pose3 kElsewhere{slam::ExpSo3({0.3, -0.8, 2.0}), {10.0, -20.0, 3.0}};

TEST(ErrorFromMaster, IsOverAllPosesButTheFirst) {
  const Trajectory truth{At(0, 0), At(1, 0), At(2, 0)};
  const Trajectory poses{At(0, 0), At(1, 0.3, 0.01), At(2.4, 0, -0.07)};
  const TrajectoryError e = ErrorFromMaster(poses, truth);
  EXPECT_EQ(e.translation.count, 2u);
  EXPECT_NEAR(e.translation.rms, std::sqrt((0.09 + 0.16) / 2.0), 1e-12);
  EXPECT_NEAR(e.translation.mean, 0.35, 1e-12);
  EXPECT_NEAR(e.translation.max, 0.4, 1e-12);
  EXPECT_NEAR(e.rotation.rms, 0.05, 1e-9) << "sqrt((0.01^2 + 0.07^2) / 2)";
  EXPECT_NEAR(e.rotation.max, 0.07, 1e-9);
}

TEST(ErrorFromMaster, DoesNotDependOnTheFrameOfEither) {
  const Trajectory truth{At(0, 0), At(1, 0), At(2, 0)};
  const Trajectory poses{At(0, 0), At(1, 0.3), At(2.4, 0)};
  const TrajectoryError expected = ErrorFromMaster(poses, truth);
  const TrajectoryError e = ErrorFromMaster(Moved(kElsewhere, poses), truth);
  EXPECT_NEAR(e.translation.rms, expected.translation.rms, 1e-12);
  EXPECT_NEAR(e.translation.max, expected.translation.max, 1e-12);
}

TEST(ErrorFromMaster, LetsAnErrorOfTheFirstHeadingGrowWithTheDistance) {
  // A master that is turned by 0.1 rad puts a pose 10 m away off by the chord.
  const TrajectoryError e = ErrorFromMaster({At(0, 0, 0.1), At(10, 0)}, {At(0, 0), At(10, 0)});
  EXPECT_NEAR(e.translation.max, 20.0 * std::sin(0.05), 1e-12);
  EXPECT_NEAR(e.rotation.max, 0.1, 1e-9);
}

// Points on a cross, stretched by 1.2 along x and 1.1 along y. The cross-covariance of the two is diagonal
// and positive, and their centroids agree: the best rotation and translation are none, and the errors that
// are left are 0.2, 0.2, 0.1, 0.1. This is evo's ape with --align (Umeyama without scale).
const Trajectory kCross{At(1, 0), At(-1, 0), At(0, 1), At(0, -1)};
const Trajectory kStretched{At(1.2, 0, 0.05), At(-1.2, 0, 0.05), At(0, 1.1, -0.01), At(0, -1.1, -0.01)};

TEST(ErrorAligned, AgreesWithEvoOnACross) {
  for (const Pose3& T_other_map : {Pose3(), kElsewhere}) {
    const AlignedError aligned = ErrorAligned(Moved(T_other_map, kStretched), kCross);
    const Summary& t = aligned.error.translation;
    EXPECT_TRUE(aligned.unique);
    EXPECT_EQ(t.count, 4u);
    EXPECT_NEAR(t.rms, std::sqrt(0.025), 1e-12);
    EXPECT_NEAR(t.mean, 0.15, 1e-12);
    EXPECT_NEAR(t.median, 0.15, 1e-12);
    EXPECT_NEAR(t.standard_deviation, 0.05, 1e-12);
    EXPECT_NEAR(t.min, 0.1, 1e-12);
    EXPECT_NEAR(t.max, 0.2, 1e-12);
    EXPECT_NEAR(aligned.error.rotation.max, 0.05, 1e-9);
    EXPECT_NEAR(aligned.error.rotation.mean, 0.03, 1e-9);
    EXPECT_LT(slam::TranslationDistance(aligned.T_true_map, T_other_map.Inverse()), 1e-12);
    EXPECT_LT(slam::RotationDistance(aligned.T_true_map, T_other_map.Inverse()), 1e-7);
  }
}

TEST(ErrorAligned, TellsWhenALineLeavesATurnFree) {
  const Trajectory line{At(0, 0), At(1, 0), At(2, 0), At(5, 0)};
  const AlignedError aligned = ErrorAligned(Moved(kElsewhere, line), line);
  EXPECT_FALSE(aligned.unique);
  EXPECT_NEAR(aligned.error.translation.max, 0.0, 1e-9);
}

TEST(ErrorRelative, TakesThePairsOfEvo) {
  const Trajectory truth{At(0, 0), At(1, 0), At(2, 0), At(3, 0), At(4, 0)};
  const Trajectory poses{At(0, 0), At(1.1, 0), At(2.1, 0), At(3.3, 0), At(4.3, 0)};
  const Summary steps = ErrorRelative(poses, truth).translation;  // 0.1, 0, 0.2, 0
  EXPECT_EQ(steps.count, 4u);
  EXPECT_NEAR(steps.rms, std::sqrt(0.05 / 4.0), 1e-12);
  EXPECT_NEAR(steps.median, 0.05, 1e-12);
  const Summary twos = ErrorRelative(poses, truth, {2, false}).translation;  // (0, 2) and (2, 4): 0.1, 0.2
  EXPECT_EQ(twos.count, 2u);
  EXPECT_NEAR(twos.mean, 0.15, 1e-12);
  const Summary all = ErrorRelative(poses, truth, {2, true}).translation;  // and (1, 3): 0.2
  EXPECT_EQ(all.count, 3u);
  EXPECT_NEAR(all.mean, 0.5 / 3.0, 1e-12);
}

TEST(ErrorRelative, CountsATurnOnceWhereItHappens) {
  // From pose 1 on everything is turned by 0.1 rad about pose 1: only the step to it is wrong, by the
  // angle.
  const Trajectory truth{At(0, 0), At(1, 0), At(2, 0), At(3, 0)};
  const Trajectory poses{At(0, 0), At(1, 0, 0.1), At(1 + std::cos(0.1), std::sin(0.1), 0.1),
                         At(1 + 2 * std::cos(0.1), 2 * std::sin(0.1), 0.1)};
  const TrajectoryError e = ErrorRelative(Moved(kElsewhere, poses), truth);
  EXPECT_NEAR(e.translation.max, 0.0, 1e-12);
  EXPECT_NEAR(e.rotation.max, 0.1, 1e-9);
  EXPECT_NEAR(e.rotation.mean, 0.1 / 3.0, 1e-7);
  EXPECT_NEAR(ErrorFromMaster(poses, truth).translation.max, 4.0 * std::sin(0.05), 1e-12);
}

TEST(TrajectoryError, IsNothingWhereThereIsNothingToCompare) {
  EXPECT_EQ(ErrorFromMaster({At(1, 2)}, {At(5, 6)}).translation.count, 0u);
  EXPECT_EQ(ErrorAligned({}, {}).error.translation.count, 0u);
  EXPECT_EQ(ErrorRelative({At(1, 2)}, {At(5, 6)}).translation.count, 0u);
}

TEST(TrajectoryError, WantsAsManyPosesAsTruths) {
  EXPECT_THROW(ErrorFromMaster({At(1, 2)}, {}), Error);
  EXPECT_THROW(ErrorAligned({At(1, 2)}, {}), Error);
  EXPECT_THROW(ErrorRelative({At(1, 2)}, {}), Error);
  EXPECT_THROW(ErrorRelative({}, {}, {0, false}), Error);
}

TEST(MeasurePath, AddsUpTheStepsAndTurns) {
  const PathStatistics path = MeasurePath({At(0, 0), At(3, 4, 0.5), At(3, 5, -0.5)});
  EXPECT_EQ(path.scans, 3u);
  EXPECT_DOUBLE_EQ(path.length, 6.0);
  EXPECT_NEAR(path.turned, 1.5, 1e-12);
  EXPECT_EQ(MeasurePath({}).length, 0.0);
}

}  // namespace
}  // namespace ariadne::experiments
