#include "control/indiveri.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

Pose2 DrawPose(RandomStream& stream) {
  return {DrawUniform(stream, -M_PI, M_PI),
          {DrawUniform(stream, -8.0, 8.0), DrawUniform(stream, -8.0, 8.0)}};
}

double Lyapunov(const Pose2& T_goal_robot, double h) {
  const double x = T_goal_robot.translation.x(), y = T_goal_robot.translation.y();
  const double theta = std::atan2(-y, -x);
  const double alpha = std::remainder(theta - T_goal_robot.angle, 2.0 * M_PI);
  return 0.5 * (alpha * alpha + h * theta * theta);
}

TEST(Indiveri, SeesTheGoalAsInFig8) {
  // The robot stands 3 m left of the goal's axis and 4 m before the goal, heading parallel to the axis.
  const GoalBearing bearing = BearingOf({0.0, {-4.0, 3.0}});
  EXPECT_DOUBLE_EQ(bearing.distance, 5.0);
  EXPECT_DOUBLE_EQ(bearing.theta, std::atan2(-3.0, 4.0));
  EXPECT_DOUBLE_EQ(bearing.alpha, bearing.theta);
  // Behind the goal and a little right of its axis: theta is nearly pi, and 3 + pi is wrapped.
  EXPECT_NEAR(BearingOf({-3.0, {1.0, -1e-9}}).alpha, 3.0 - M_PI, 1e-8);
  for (const double y : {0.0, -0.0}) EXPECT_EQ(BearingOf({0.0, {1.0, y}}).theta, M_PI);
}

TEST(Indiveri, SteersAsTheFormulaSays) {
  RandomStream stream = NamedStream(1, "test/indiveri");
  for (int trial = 0; trial < 1000; ++trial) {
    const Pose2 pose = DrawPose(stream);
    const IndiveriOptions options{DrawUniform(stream, 0.5, 2.0), 2.0, 2.9};
    const long double x = pose.translation.x(), y = pose.translation.y();
    const long double e = std::hypot(x, y), theta = std::atan2(-y, -x);
    const long double alpha = std::remainder(theta - pose.angle, 2.0L * M_PIl);
    const long double c =
        std::sin(alpha) / e + 2.0L * theta / e * std::sin(alpha) / alpha + 2.9L * alpha / e;
    const DriveCommand command = SteerToGoal(pose, options);
    EXPECT_NEAR(command.forward, options.gamma * static_cast<double>(e), 1e-12);
    EXPECT_NEAR(command.turning, command.forward * static_cast<double>(c), 1e-11);
    EXPECT_NEAR(PathCurvature(BearingOf(pose), options), static_cast<double>(c), 1e-10);
  }
}

TEST(Indiveri, IsSmoothWhereTheRobotHeadsForTheGoal) {
  for (const double alpha : {0.0, 1e-300, 1e-9, 9.999e-5, 1.0001e-4, 1e-3}) {
    const GoalBearing bearing{2.0, 0.7, alpha};
    const double sinc = alpha == 0.0 ? 1.0 : static_cast<double>(std::sin(1.0L * alpha) / alpha);
    EXPECT_NEAR(PathCurvature(bearing, {}), (std::sin(alpha) + 1.4 * sinc + 2.9 * alpha) / 2.0, 1e-15);
  }
}

TEST(Indiveri, LetsVFallAsTheProofSays) {
  RandomStream stream = NamedStream(2, "test/indiveri");
  const IndiveriOptions options;
  int compared = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Pose2 pose = DrawPose(stream);
    const GoalBearing bearing = BearingOf(pose);
    if (bearing.distance < 0.5 || std::abs(bearing.theta) > 3.1 || std::abs(bearing.alpha) > 3.1) continue;
    const DriveCommand command = SteerToGoal(pose, options);
    const double step = 1e-6;
    const auto v_after = [&](double time) {
      return Lyapunov(pose * Pose2::Exp({command.forward * time, 0.0, command.turning * time}), options.h);
    };
    const double slope = (v_after(step) - v_after(-step)) / (2.0 * step);
    const double expected =
        -command.forward / bearing.distance * options.beta * bearing.alpha * bearing.alpha;
    EXPECT_NEAR(slope, expected, 1e-6);
    ++compared;
  }
  EXPECT_GT(compared, 900);
}

TEST(Indiveri, MirrorsWithTheRobot) {
  RandomStream stream = NamedStream(3, "test/indiveri");
  for (int trial = 0; trial < 100; ++trial) {
    const Pose2 pose = DrawPose(stream);
    const DriveCommand left = SteerToGoal(pose, {});
    const DriveCommand right =
        SteerToGoal({-pose.angle, {pose.translation.x(), -pose.translation.y()}}, {});
    EXPECT_DOUBLE_EQ(left.forward, right.forward);
    EXPECT_NEAR(left.turning, -right.turning, 1e-12);
  }
}

TEST(Indiveri, StandsAtTheGoal) {
  const DriveCommand command = SteerToGoal({1.0, {0.0, 0.0}}, {});
  EXPECT_EQ(command.forward, 0.0);
  EXPECT_EQ(command.turning, 0.0);
  EXPECT_EQ(PathCurvature(BearingOf({1.0, {0.0, 0.0}}), {}), 0.0);
}

TEST(Indiveri, RefusesGainsThatDoNotEndStraight) {
  RequireGains({});
  RequireGains({1.0, 4.0, 4.9});
  EXPECT_EQ(ErrorOf([] {
              RequireGains({1.0, 1.0, 1.9});
            }),
            "law.h is 1, but the path only ends straight with more than 1");
  EXPECT_EQ(ErrorOf([] {
              RequireGains({1.0, 2.0, 3.0});
            }),
            "law.beta is 3, but the path only ends straight with more than 2 and less than h + 1 = 3");
  EXPECT_NE(ErrorOf([] { RequireGains({1.0, 2.0, 2.0}); }), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ErrorOf([&] { RequireGains({1.0, nan, 2.5}); }), "");
  EXPECT_NE(ErrorOf([&] { RequireGains({-1.0, 2.0, 2.5}); }).find("law.gamma"), std::string::npos);
  RequireGains({1.0, 2.0, 3.5, true});
}

}  // namespace
}  // namespace ariadne::control
