#include "control/avoidance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/control/sweep_oracle.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using Eigen::Vector2d;
using slam::Pose2;

using Points = std::vector<Vector2d>;

/// Every 2 cm, as a scanner sees it.
Points WallBetween(const Vector2d& a, const Vector2d& b) {
  Points points;
  const int count = static_cast<int>(std::ceil((b - a).norm() / 0.02));
  for (int i = 0; i <= count; ++i) points.push_back(a + (b - a) * i / count);
  return points;
}

struct Drive {
  Pose2 T_map_robot;
  DriveCommand velocity;
  bool blocked = false;
};

RectangleOptions Bare() {
  RectangleOptions robot;
  robot.margin = 0.0;
  return robot;
}

AvoidanceOptions WithoutRepulsion() {
  AvoidanceOptions options;
  options.repulsion = 0.0;
  return options;
}

/// Lets the robot drive for a while, commands being carried out within the limits, and expects it to touch
/// nothing.
Drive DriveAmong(Drive drive, const DriveCommand& wanted, const Points& points_map, double time) {
  const AvoidanceOptions options;
  int stands = 0;
  for (int period = 0; period * options.period < time; ++period) {
    Points points_base;
    for (const Vector2d& p : points_map) points_base.push_back(drive.T_map_robot.Inverse() * p);
    const AvoidanceResult result = Avoid(wanted, drive.velocity, points_base, options);
    drive.velocity = Limited(result.command, drive.velocity, options.period, options.limits);
    drive.blocked = result.blocked;
    const Pose2 before = drive.T_map_robot;
    drive.T_map_robot = before * Pose2::Exp({options.period * drive.velocity.forward, 0.0,
                                             options.period * drive.velocity.turning});
    EXPECT_FALSE(FirstTouch(Bare(), before, drive.T_map_robot, points_map).has_value()) << period;
    stands = drive.velocity.forward == 0.0 && drive.velocity.turning == 0.0 ? stands + 1 : 0;
    if (testing::Test::HasFailure() || stands > 10) break;
  }
  return drive;
}

double NearestOf(const Pose2& T_map_robot, const Points& points_map) {
  double nearest = 1e9;
  for (const Vector2d& p : points_map) nearest = std::min(nearest, GapTo(Bare(), T_map_robot, p));
  return nearest;
}

TEST(Avoidance, StopsBeforeAWallAtAnyAngle) {
  RandomStream stream = NamedStream(1, "test/avoid");
  for (int trial = 0; trial < 24; ++trial) {
    SCOPED_TRACE(trial);
    const double sense = trial % 2 == 0 ? 1.0 : -1.0;
    const double angle = DrawUniform(stream, -1.2, 1.2);
    const Vector2d foot(sense * DrawUniform(stream, 2.7, 3.5), DrawUniform(stream, -0.3, 0.3));
    const Vector2d along(4.0 * std::sin(angle), 4.0 * std::cos(angle));
    const Points wall = WallBetween(foot - along, foot + along);
    // At full speed at once, on a line or a curve that changes nothing about where it ends.
    const DriveCommand wanted{0.8 * sense, trial % 4 < 2 ? 0.0 : DrawUniform(stream, -0.15, 0.15)};
    const Drive end = DriveAmong({{}, wanted, false}, wanted, wall, 12.0);
    if (std::abs(angle) > 0.5) continue;  // it may slide along
    EXPECT_LT(NearestOf(end.T_map_robot, wall), 0.1) << "nor does it stop far away";
    EXPECT_TRUE(end.blocked || std::abs(angle) > 0.1);
  }
}

TEST(Avoidance, BrakesForWhatAppears) {
  // 0.64 m of braking at 0.5 m/s^2, 0.1 s and a period of reaction, the margin.
  const DriveCommand fast{0.8, 0.0};
  for (const double distance : {0.80, 1.0}) {
    const Points wall = WallBetween({0.4 + distance, -1.0}, {0.4 + distance, 1.0});
    const Drive end = DriveAmong({{}, fast, false}, fast, wall, 10.0);
    EXPECT_TRUE(end.blocked);
    EXPECT_EQ(end.velocity.forward, 0.0);
    EXPECT_LT(NearestOf(end.T_map_robot, wall), 0.05);
  }
  const AvoidanceResult late = Avoid(fast, fast, {{0.8, 0.0}}, {});
  EXPECT_TRUE(late.blocked) << "too late, but it brakes";
  EXPECT_EQ(late.command.forward, 0.0);
  ASSERT_TRUE(late.p_base.has_value());
  EXPECT_EQ(*late.p_base, Vector2d(0.8, 0.0));
}

TEST(Avoidance, LeavesACommandAloneWhereNothingIsInItsWay) {
  const Points behind_and_far = {{-0.6, 0.0}, {4.0, 0.0}, {0.0, 0.5}, {0.2, -0.5}};
  for (const DriveCommand& wanted : {DriveCommand{0.8, 0.0}, DriveCommand{0.3, 0.05}, DriveCommand{}}) {
    for (const Points& points : {Points{}, behind_and_far}) {
      if (!points.empty() && wanted.turning != 0.0) continue;
      const AvoidanceResult result = Avoid(wanted, {}, points, WithoutRepulsion());
      EXPECT_EQ(result.command.forward, wanted.forward);
      EXPECT_EQ(result.command.turning, wanted.turning);
      EXPECT_FALSE(result.blocked);
      EXPECT_FALSE(result.p_base.has_value());
    }
  }
}

TEST(Avoidance, IsTheSameInAMirrorAndBackward) {
  RandomStream stream = NamedStream(2, "test/avoid");
  int slowed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const DriveCommand wanted{DrawUniform(stream, -0.8, 0.8), DrawUniform(stream, -0.5, 0.5)};
    const DriveCommand velocity{DrawUniform(stream, -0.3, 0.3), DrawUniform(stream, -0.3, 0.3)};
    Points points, mirrored, turned;
    for (int i = 0; i < 5; ++i) {
      const Vector2d p(DrawUniform(stream, -1.5, 1.5), DrawUniform(stream, -1.2, 1.2));
      points.push_back(p), mirrored.emplace_back(p.x(), -p.y()), turned.push_back(-p);
    }
    const AvoidanceResult here = Avoid(wanted, velocity, points, {});
    const AvoidanceResult mirror =
        Avoid({wanted.forward, -wanted.turning}, {velocity.forward, -velocity.turning}, mirrored, {});
    const AvoidanceResult back =
        Avoid({-wanted.forward, wanted.turning}, {-velocity.forward, velocity.turning}, turned, {});
    EXPECT_NEAR(mirror.command.forward, here.command.forward, 1e-6);
    EXPECT_NEAR(mirror.command.turning, -here.command.turning, 1e-6);
    EXPECT_NEAR(back.command.forward, -here.command.forward, 1e-6);
    EXPECT_NEAR(back.command.turning, here.command.turning, 1e-6);
    EXPECT_EQ(mirror.blocked, here.blocked);
    EXPECT_LE(std::abs(here.command.forward), std::abs(wanted.forward) + 1e-12);
    slowed += here.p_base ? 1 : 0;
  }
  EXPECT_GT(slowed, 50);
  EXPECT_LT(slowed, 190);
}

TEST(Avoidance, DoesNotTurnItsCornersIntoSomething) {
  // Beside the robot; its corner passes at 0.5 m, at an angle of 37 deg.
  const Points wall = WallBetween({-1.0, 0.38}, {1.0, 0.38});
  const DriveCommand turn{0.0, 1.0};
  const Drive end = DriveAmong({}, turn, wall, 5.0);
  EXPECT_TRUE(end.blocked);
  EXPECT_GT(std::abs(end.T_map_robot.angle), 0.05);
  EXPECT_LT(NearestOf(end.T_map_robot, wall), 0.04);
  EXPECT_EQ(Avoid(turn, {}, WallBetween({-1.0, 0.7}, {1.0, 0.7}), {}).command.turning, 1.0);
}

TEST(Avoidance, TurnsAwayFromWhatIsAheadOnOneSide) {
  const DriveCommand wanted{0.4, 0.0};
  EXPECT_LT(Avoid(wanted, wanted, {{0.6, 0.35}}, {}).command.turning, -0.01);
  EXPECT_GT(Avoid(wanted, wanted, {{0.6, -0.35}}, {}).command.turning, 0.01);
  EXPECT_EQ(Avoid(wanted, wanted, {{0.6, -0.35}, {0.6, 0.35}}, {}).command.turning, 0.0);
  EXPECT_EQ(Avoid(wanted, wanted, {{-0.6, 0.35}}, {}).command.turning, 0.0) << "behind";
  EXPECT_GT(Avoid({-0.4, 0.0}, {-0.4, 0.0}, {{-0.6, 0.35}}, {}).command.turning, 0.01) << "backward";
  // Past an obstacle that it would graze.
  const Drive end = DriveAmong({}, wanted, WallBetween({2.0, 0.29}, {2.0, 0.6}), 8.0);
  EXPECT_GT(end.T_map_robot.translation.x(), 2.4);
}

TEST(Avoidance, MayLeaveWhatIsNearerThanTheMargin) {
  const Points before = WallBetween({0.41, -0.3}, {0.41, 0.3});
  EXPECT_TRUE(Avoid({0.2, 0.0}, {}, before, {}).blocked);
  EXPECT_LT(Avoid({-0.2, 0.0}, {}, before, {}).command.forward, -0.19);
  const Points beside = WallBetween({-1.0, 0.31}, {1.0, 0.31});
  EXPECT_GT(Avoid({0.2, 0.0}, {}, beside, WithoutRepulsion()).command.forward, 0.19);
  EXPECT_TRUE(Avoid({0.0, 0.5}, {}, beside, {}).blocked);
}

TEST(Avoidance, PassesADoor) {
  Points door = WallBetween({1.5, 0.40}, {1.5, 2.0});
  const Points right = WallBetween({1.5, -0.40}, {1.5, -2.0});
  door.insert(door.end(), right.begin(), right.end());
  const Drive end = DriveAmong({}, {0.5, 0.0}, door, 10.0);
  EXPECT_GT(end.T_map_robot.translation.x(), 3.0);
  EXPECT_FALSE(end.blocked);
}

TEST(Avoidance, RefusesWhatIsNotFinite) {
  EXPECT_NE(ErrorOf([] {
              Avoid({}, {}, {{std::nan(""), 0.0}}, {});
            }).find("not finite"),
            std::string::npos);
  AvoidanceOptions options;
  options.period = 0.0;
  EXPECT_NE(ErrorOf([&] { Avoid({}, {}, {}, options); }).find("avoidance.period"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::control
