#include "control/simulate_approach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "control/differential_drive.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

/// The law alone, nearly continuous: motors that follow at once.
ApproachOptions Ideal() {
  ApproachOptions options;
  options.limits.acceleration = options.limits.turning_acceleration = 1e6;
  options.limits.max_wheel_speed = 100.0;
  options.period = 0.005;
  options.final_turn = false;
  return options;
}

Pose2 DrawStart(RandomStream& stream) {
  const double distance = 10.0 * std::sqrt(DrawUniform(stream, 0.0, 1.0));
  const double direction = DrawUniform(stream, -M_PI, M_PI);
  return {DrawUniform(stream, -M_PI, M_PI),
          {distance * std::cos(direction), distance * std::sin(direction)}};
}

double PoseError(const Pose2& a, const Pose2& b) { return (a.Inverse() * b).Log().norm(); }

TEST(SimulateApproach, ReachesTheGoalWithinAllLimits) {
  RandomStream stream = NamedStream(1, "test/approach");
  const ApproachOptions options;
  for (int trial = 0; trial < 200; ++trial) {
    const ApproachResult result = SimulateApproach(DrawStart(stream), {}, options);
    ASSERT_EQ(result.status, ApproachStatus::kReached);
    const Pose2& end = result.samples.back().T_map_robot;
    EXPECT_LE(end.translation.norm(), 0.01);
    EXPECT_LE(std::abs(end.angle), 0.5 * M_PI / 180.0);
    DriveCommand before;
    for (const ApproachSample& sample : result.samples) {
      const DriveCommand& command = sample.command;
      const WheelPair wheels = WheelsOf(command.forward, command.turning, options.limits.track);
      ASSERT_GE(command.forward, 0.0) << "no cusps";
      ASSERT_LE(command.forward, 0.8 + 1e-9);
      ASSERT_LE(std::abs(command.turning), 1.0 + 1e-9);
      ASSERT_LE(std::max(std::abs(wheels.left), std::abs(wheels.right)), 1.05 + 1e-9);
      ASSERT_LE(std::abs(command.forward - before.forward), 0.5 * 0.05 + 1e-9);
      ASSERT_LE(std::abs(command.turning - before.turning), 1.0 * 0.05 + 1e-9);
      before = command;
    }
  }
}

TEST(SimulateApproach, NeverLetsVGrow) {
  RandomStream stream = NamedStream(2, "test/approach");
  for (int trial = 0; trial < 30; ++trial) {
    const ApproachResult result = SimulateApproach(DrawStart(stream), {}, Ideal());
    double before = std::numeric_limits<double>::infinity();
    double allowed = 0.0;
    for (const ApproachSample& sample : result.samples) {
      const GoalBearing bearing = BearingOf(sample.T_map_robot);
      const double v = 0.5 * (bearing.alpha * bearing.alpha + 2.0 * bearing.theta * bearing.theta);
      ASSERT_LE(v, before + allowed);
      before = v;
      // Commands are held for a period, and where alpha is 0 and V stands still, that shows.
      allowed = 2.0 * std::pow(0.005 * sample.command.turning, 2.0) + 1e-12;
    }
  }
}

/// The largest curvature in a ring around the goal.
double CurvatureWithin(const ApproachResult& result, double from, double to) {
  double largest = 0.0;
  for (const ApproachSample& sample : result.samples) {
    const double distance = sample.T_map_robot.translation.norm();
    if (distance < from || distance > to || sample.command.forward == 0.0) continue;
    largest = std::max(largest, std::abs(sample.command.turning / sample.command.forward));
  }
  return largest;
}

TEST(SimulateApproach, EndsStraightIfAndOnlyIfTheGainsAllowIt) {
  for (const double h : {0.8, 1.5, 2.0, 4.0}) {
    for (const double beta : {1.5, 2.3, 2.9, 3.5, 4.5, 5.5}) {
      ApproachOptions options = Ideal();
      options.law = {1.0, h, beta, true};
      options.goal_distance = 1e-5;
      const ApproachResult result = SimulateApproach({0.3, {-3.0, 1.0}}, {}, options);
      ASSERT_EQ(result.status, ApproachStatus::kReached) << "stable it is in any case";
      const double growth = CurvatureWithin(result, 1e-5, 3e-5) / CurvatureWithin(result, 0.1, 0.3);
      if (h > 1.0 && beta > 2.0 && beta < h + 1.0) {
        EXPECT_LT(growth, 0.7) << h << ", " << beta;
      } else {
        EXPECT_GT(growth, 1.5) << h << ", " << beta;
      }
    }
  }
}

double DistanceToPath(const Eigen::Vector2d& p, const ApproachResult& path) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < path.samples.size(); ++k) {
    const Eigen::Vector2d& a = path.samples[k - 1].T_map_robot.translation;
    const Eigen::Vector2d ab = path.samples[k].T_map_robot.translation - a;
    const double along = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-18), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * ab).norm());
  }
  return nearest;
}

TEST(SimulateApproach, FollowsTheSamePathSlowly) {
  ApproachOptions fast = Ideal();
  fast.limits.max_speed = 10.0, fast.limits.max_turning = 100.0;
  fast.period = 5e-4;
  ApproachOptions slow = Ideal();
  slow.limits.max_speed = 0.5, slow.limits.max_turning = 0.4;
  for (const Pose2& start : {Pose2{2.0, {-3.0, 1.0}}, Pose2{-3.0, {-2.0, 0.5}}, Pose2{0.4, {3.0, -1.0}}}) {
    const ApproachResult path = SimulateApproach(start, {}, fast);
    const ApproachResult saturated = SimulateApproach(start, {}, slow);
    EXPECT_GT(saturated.duration, 1.5 * path.duration);
    EXPECT_NEAR(saturated.length, path.length, 0.005 * path.length);
    for (std::size_t k = 0; k < saturated.samples.size(); k += 50) {
      EXPECT_LT(DistanceToPath(saturated.samples[k].T_map_robot.translation, path), 0.003);
    }
  }
}

TEST(SimulateApproach, DrivesOneArcPerPeriod) {
  const ApproachResult result = SimulateApproach({2.0, {-3.0, 1.0}}, {0.4, {1.0, 2.0}}, {});
  double length = 0.0;
  double turned = 0.0;
  for (std::size_t k = 1; k < result.samples.size(); ++k) {
    const auto& [time, T_map_robot, command] = result.samples[k - 1];
    EXPECT_NEAR(result.samples[k].time - time, 0.05, 1e-9);
    const WheelPair ways = WheelsOf(0.05 * command.forward, 0.05 * command.turning, 0.5);
    EXPECT_LT(PoseError(result.samples[k].T_map_robot, T_map_robot * RollArc(ways, 0.5)), 1e-9);
    length += 0.05 * command.forward;
    turned += 0.05 * std::abs(command.turning);
  }
  EXPECT_NEAR(result.length, length, 1e-9);
  EXPECT_NEAR(result.turned, turned, 1e-9);
  EXPECT_EQ(result.duration, result.samples.back().time);
  EXPECT_EQ(result.samples.back().command.forward, 0.0);
  EXPECT_LT(PoseError(result.samples.front().T_map_robot, {2.0, {-3.0, 1.0}}), 1e-14);
}

TEST(SimulateApproach, IsTheSameInAnyFrame) {
  const Pose2 T_new_map{2.2, {-40.0, 17.0}};
  const Pose2 start{2.0, {-3.0, 1.0}};
  const Pose2 goal{-0.4, {1.0, 2.0}};
  const ApproachResult here = SimulateApproach(start, goal, {});
  const ApproachResult there = SimulateApproach(T_new_map * start, T_new_map * goal, {});
  ASSERT_EQ(here.samples.size(), there.samples.size());
  for (std::size_t k = 0; k < here.samples.size(); ++k) {
    EXPECT_LT(PoseError(T_new_map * here.samples[k].T_map_robot, there.samples[k].T_map_robot), 1e-9);
  }
}

TEST(SimulateApproach, CostsWhatItTakes) {
  RandomStream stream = NamedStream(3, "test/approach");
  for (int trial = 0; trial < 10; ++trial) {
    const Pose2 start = DrawStart(stream);
    const Pose2 goal = DrawStart(stream);
    const ApproachResult result = SimulateApproach(start, goal, {});
    const ApproachCostResult cost = ApproachCost(start, goal, {});
    EXPECT_EQ(cost.status, result.status);
    EXPECT_EQ(cost.length, result.length);
    EXPECT_EQ(cost.duration, result.duration);
    EXPECT_EQ(cost.turned, result.turned);
  }
}

TEST(SimulateApproach, AheadIsAStraightLine) {
  const ApproachResult result = SimulateApproach({0.0, {-5.0, 0.0}}, {}, {});
  EXPECT_NEAR(result.length, 4.99, 0.001);
  EXPECT_EQ(result.turned, 0.0);
  // 0.8 m/s but for the start, and the end, which is approached as exp(-t).
  EXPECT_NEAR(result.duration, 0.8 + (4.99 - 0.32 - 0.79) / 0.8 + std::log(0.8 / 0.01), 0.5);
}

TEST(SimulateApproach, AtTheGoalOnlyTurns) {
  const ApproachResult turned = SimulateApproach({2.0, {1.0, 1.0}}, {-1.0, {1.0, 1.0}}, {});
  EXPECT_EQ(turned.length, 0.0);
  EXPECT_NEAR(turned.turned, 3.0, 0.005);
  EXPECT_NEAR(turned.duration, 1.0 + 3.0, 0.3) << "a second to get up to speed and to stop";
  EXPECT_NEAR(turned.samples.back().T_map_robot.angle, -1.0, 0.0045);
  ApproachOptions options;
  options.final_turn = false;
  EXPECT_EQ(SimulateApproach({2.0, {1.0, 1.0}}, {-1.0, {1.0, 1.0}}, options).samples.size(), 1u);
}

TEST(SimulateApproach, GivesUp) {
  ApproachOptions hurried;
  hurried.max_time = 2.0;
  const ApproachResult late = SimulateApproach({0.0, {-5.0, 0.0}}, {}, hurried);
  EXPECT_EQ(late.status, ApproachStatus::kTimeOut);
  EXPECT_NEAR(late.duration, 2.0, 0.06);
  ApproachOptions confined;
  confined.max_excursion = 0.05;
  // It heads away from the goal and needs 0.6 m to turn back.
  EXPECT_EQ(SimulateApproach({3.0, {-3.0, 0.0}}, {}, confined).status, ApproachStatus::kLeftBehind);
  EXPECT_EQ(SimulateApproach({0.0, {-3.0, 0.0}}, {}, confined).status, ApproachStatus::kReached);
  EXPECT_EQ(ApproachCost({3.0, {-3.0, 0.0}}, {}, confined).status, ApproachStatus::kLeftBehind);
}

TEST(SimulateApproach, RefusesWhatIsNoApproach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ErrorOf([&] { SimulateApproach({nan, {0.0, 0.0}}, {}, {}); }), "");
  EXPECT_NE(ErrorOf([&] {
              ApproachCost({}, {0.0, {0.0, nan}}, {});
            }).find("an approach cannot lead from (0, 0, 0 rad) to (0, nan, 0 rad)"),
            std::string::npos);
  ApproachOptions options;
  options.law.beta = 3.0;
  EXPECT_NE(ErrorOf([&] { SimulateApproach({}, {}, options); }).find("beta"), std::string::npos);
  options = {};
  options.period = 0.0;
  EXPECT_NE(ErrorOf([&] { SimulateApproach({}, {}, options); }).find("approach.period"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::control
