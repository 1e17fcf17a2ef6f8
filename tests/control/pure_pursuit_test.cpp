#include "control/pure_pursuit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/differential_drive.h"
#include "slam/base/random.h"
#include "slam/geometry/angles.h"
#include "tests/control/random_path.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

void ExpectWithinLimits(const ApproachResult& result, const FollowOptions& options) {
  const DriveLimits& limits = options.limits;
  DriveCommand before;
  for (const ApproachSample& sample : result.samples) {
    const DriveCommand& command = sample.command;
    const WheelPair wheels = WheelsOf(command.forward, command.turning, limits.track);
    ASSERT_LE(std::abs(command.forward), limits.max_speed + 1e-9);
    ASSERT_LE(std::abs(command.turning), limits.max_turning + 1e-9);
    ASSERT_LE(std::max(std::abs(wheels.left), std::abs(wheels.right)), limits.max_wheel_speed + 1e-9);
    ASSERT_LE(std::abs(command.forward - before.forward), limits.acceleration * options.period + 1e-9);
    ASSERT_LE(std::abs(command.turning - before.turning),
              limits.turning_acceleration * options.period + 1e-9);
    before = command;
  }
  EXPECT_EQ(before.forward, 0.0);
  EXPECT_EQ(before.turning, 0.0);
}

double DistanceToPlaces(const Eigen::Vector2d& p, const std::vector<Pose2>& path) {
  double nearest = (p - path.front().translation).norm();
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Eigen::Vector2d& a = path[k - 1].translation;
    const Eigen::Vector2d ab = path[k].translation - a;
    const double along = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-18), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * ab).norm());
  }
  return nearest;
}

double LateralError(const ApproachResult& result, const std::vector<Pose2>& path) {
  double worst = 0.0;
  for (const ApproachSample& sample : result.samples)
    worst = std::max(worst, DistanceToPlaces(sample.T_map_robot.translation, path));
  return worst;
}

void ExpectAtEnd(const ApproachResult& result, const std::vector<Pose2>& path) {
  EXPECT_EQ(result.status, ApproachStatus::kReached);
  const Pose2 error = path.back().Inverse() * result.samples.back().T_map_robot;
  EXPECT_LE(error.translation.norm(), 0.01);
  EXPECT_LE(std::abs(slam::DegFromRad(error.angle)), 0.5);
}

TEST(PurePursuit, FollowsRandomPathsWithCuspsAndTurns) {
  RandomStream stream = NamedStream(1, "test/pursuit");
  const FollowOptions options;
  for (int trial = 0; trial < 100; ++trial) {
    const Pose2 start{DrawUniform(stream, -M_PI, M_PI), {DrawUniform(stream, -5, 5), 2.0}};
    const std::vector<Pose2> path = PathOf(start, DrawPieces(stream));
    const ApproachResult result = SimulateFollowing(path, start, options);
    SCOPED_TRACE(trial);
    ExpectAtEnd(result, path);
    ExpectWithinLimits(result, options);
    EXPECT_LE(LateralError(result, path), 0.015);
  }
}

TEST(PurePursuit, ComesBackToThePath) {
  RandomStream stream = NamedStream(2, "test/pursuit");
  const FollowOptions options;
  const std::vector<Pose2> path = PathOf({}, {{1.5, 0.0}, {1.0, 1.0}, {1.0, 0.0}});
  for (int trial = 0; trial < 40; ++trial) {
    const Pose2 start{DrawUniform(stream, -M_PI, M_PI),
                      {DrawUniform(stream, -0.3, 0.3), DrawUniform(stream, -0.3, 0.3)}};
    const ApproachResult result = SimulateFollowing(path, start, options);
    SCOPED_TRACE(trial);
    ExpectAtEnd(result, path);
    ExpectWithinLimits(result, options);
    EXPECT_LE(LateralError(result, path), 0.5);
  }
}

TEST(PurePursuit, DrivesBackwardWhereThePathDoes) {
  const std::vector<Pose2> path = PathOf({}, {{1.0, 0.5}, {-0.8, 0.0}, {0.6, 0.0}});
  const ApproachResult result = SimulateFollowing(path, {}, {});
  ExpectAtEnd(result, path);
  double forward = 0.0, backward = 0.0;
  for (const ApproachSample& sample : result.samples) {
    forward += 0.05 * std::max(0.0, sample.command.forward);
    backward -= 0.05 * std::min(0.0, sample.command.forward);
  }
  EXPECT_NEAR(forward, 1.6, 0.01);
  EXPECT_NEAR(backward, 0.8, 0.01);
  EXPECT_LT(result.turned, 0.6) << "it does not turn at the cusps";
}

TEST(PurePursuit, TurnsInPlaceAsThePathDoes) {
  // Three quarters to the left, though one to the right would do.
  const std::vector<Pose2> path = PathOf({}, {{0.5, 0.0}, {0.0, 1.5 * M_PI}, {0.5, 0.0}});
  const ApproachResult result = SimulateFollowing(path, {}, {});
  ExpectAtEnd(result, path);
  EXPECT_NEAR(result.turned, 1.5 * M_PI, 0.05);
  for (const ApproachSample& sample : result.samples) EXPECT_GE(sample.command.turning, -0.02);
  EXPECT_NEAR(result.length, 1.0, 0.01);
}

TEST(PurePursuit, TurnsToThePathFirst) {
  const std::vector<Pose2> path = PathOf({}, {{2.0, 0.0}});
  const ApproachResult result = SimulateFollowing(path, {2.5, {0.0, 0.0}}, {});
  ExpectAtEnd(result, path);
  EXPECT_NEAR(result.length, 2.0, 0.01);
  EXPECT_NEAR(result.turned, 2.5, 0.03);
  EXPECT_EQ(result.samples[20].command.forward, 0.0);
}

TEST(PurePursuit, FollowsAPolylineWithHeadingsAlongIt) {
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {2, 0}, {2, 1.5}, {3, 2.5}, {2.5, 2.5}};
  for (const bool outgoing : {false, true}) {  // which heading a corner has
    std::vector<Pose2> path;
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const Eigen::Vector2d ab = corners[k] - corners[k - 1];
      const double heading = std::atan2(ab.y(), ab.x());
      for (int i = outgoing ? 0 : 1; i < (outgoing ? 20 : 21); ++i)
        path.push_back({heading, corners[k - 1] + 0.05 * i * ab});
    }
    const ApproachResult result = SimulateFollowing(path, path.front(), {});
    ExpectAtEnd(result, path);
    ExpectWithinLimits(result, {});
    EXPECT_LE(LateralError(result, path), 0.015);
    for (const ApproachSample& sample : result.samples) EXPECT_GE(sample.command.forward, 0.0);
  }
}

TEST(PurePursuit, IsFastWhereItMayAndSlowInCurves) {
  const ApproachResult line = SimulateFollowing(PathOf({}, {{6.0, 0.0}}), {}, {});
  EXPECT_NEAR(line.duration, 6.0 / 0.8 + 0.8 / (2.0 * 0.5) + 0.8 / (2.0 * 0.4), 0.5);
  const ApproachResult circle = SimulateFollowing(PathOf({}, {{0.4 * 6.0, 6.0}}), {}, {});
  EXPECT_GT(circle.duration, 6.0) << "1 rad/s";
  EXPECT_LT(circle.duration, 9.5);
}

TEST(PurePursuit, NeverGoesBackOnThePath) {
  RandomStream stream = NamedStream(3, "test/pursuit");
  const std::vector<Pose2> path = PathOf({}, {{2.0, 2.0}, {-1.0, 0.5}, {1.0, 0.0}});
  Pose2 pose = path.front();
  PathProgress progress;
  for (int period = 0; period < 2000; ++period) {
    // A pose that jumps by centimetres, as one that is localized does.
    const Pose2 noise =
        Pose2::Exp({DrawNormal(stream, 0, 0.01), DrawNormal(stream, 0, 0.01), DrawNormal(stream, 0, 0.01)});
    const FollowStep step = FollowPath(path, pose * noise, progress, {});
    ASSERT_GE(step.progress.leg, progress.leg);
    const bool same_leg = step.progress.leg == progress.leg;
    ASSERT_TRUE(!same_leg || step.progress.passed >= progress.passed);
    progress = step.progress;
    pose = pose * Pose2::Exp({0.05 * step.command.forward, 0.0, 0.05 * step.command.turning});
    if (progress.leg + 1 == path.size()) return;
  }
  FAIL() << "the last leg did not end";
}

TEST(PurePursuit, IsTheSameInAnyFrame) {
  RandomStream stream = NamedStream(4, "test/pursuit");
  const Pose2 T_new_map{2.2, {-40.0, 17.0}};
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<Pose2> path = PathOf({}, DrawPieces(stream));
    std::vector<Pose2> moved;
    for (const Pose2& pose : path) moved.push_back(T_new_map * pose);
    const ApproachResult here = SimulateFollowing(path, {0.3, {0.0, 0.1}}, {});
    const ApproachResult there = SimulateFollowing(moved, T_new_map * Pose2{0.3, {0.0, 0.1}}, {});
    ASSERT_EQ(here.samples.size(), there.samples.size());
    for (std::size_t k = 0; k < here.samples.size(); ++k) {
      EXPECT_LT(
          (T_new_map * here.samples[k].T_map_robot.translation - there.samples[k].T_map_robot.translation)
              .norm(),
          1e-6);
    }
  }
}

TEST(PurePursuit, OfOnePoseTurns) {
  const ApproachResult result = SimulateFollowing({{1.0, {3.0, 0.0}}}, {-1.0, {3.0, 0.0}}, {});
  EXPECT_EQ(result.length, 0.0);
  EXPECT_NEAR(result.turned, 2.0, 0.005);
  const Pose2 pose{1.0, {3.0, 0.0}};
  EXPECT_TRUE(FollowPath({pose, pose, pose}, pose, {}, {}).finished);
}

TEST(PurePursuit, GivesUp) {
  FollowOptions hurried;
  hurried.max_time = 2.0;
  EXPECT_EQ(SimulateFollowing(PathOf({}, {{5.0, 0.0}}), {}, hurried).status, ApproachStatus::kTimeOut);
}

TEST(PurePursuit, RefusesWhatIsNoPath) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PathProgress beyond;
  beyond.leg = 1;
  EXPECT_NE(ErrorOf([] { FollowPath({}, {}, {}, {}); }).find("without a pose"), std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              FollowPath({{}}, {nan, {0.0, 0.0}}, {}, {});
            }).find("not finite"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] { FollowPath({{}}, {}, beyond, {}); }).find("pose 1 of a path that has 1"),
            std::string::npos);
  FollowOptions options;
  options.period = 0.0;
  EXPECT_NE(ErrorOf([&] { FollowPath({{}}, {}, {}, options); }).find("follow.period"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::control
