#include "experiments/mission/drive_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/simulated/ais_scanner.h"
#include "slam/geometry/angles.h"
#include "tests/experiments/mission/two_rooms.h"

namespace ariadne::experiments {
namespace {

/// A robot in the two rooms that drives in the frame of the world.
class DrivePathTest : public testing::Test {
 protected:
  static drivers::SimulatedRobotOptions RobotOptions() {
    drivers::SimulatedRobotOptions options = QuickRobot();
    options.base.wheels.track_error = 0.03;  // turns by 3 % less than the encoders say
    return options;
  }
  static std::vector<slam::Pose2> Straight(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Eigen::Vector2d way = to - from;
    std::vector<slam::Pose2> poses;
    for (int i = 0; i <= 40; ++i)
      poses.push_back({std::atan2(way.y(), way.x()), from + way * static_cast<double>(i) / 40.0});
    return poses;
  }
  /// The walls as one scan of the first place has shown them.
  slam::AlignModel ModelOfFirstScan() {
    MissionMap map(QuickMission(), robot_.T_base_laser());
    const slam::Scan scan = robot_.TakeScan();
    map.AddScan("scan000", slam::ToPointCloud(scan), robot_.T_map_base_true(), {});
    return std::move(*map.ModelAround(robot_.T_map_base_true().translation, 100.0));
  }
  DriveReport Drive(const std::vector<slam::Pose2>& path, const slam::AlignModel* model,
                    const DriveOptions& options = {}) {
    const Localizer localizer(robot_, robot_.T_map_base_true(), model, scanner_, options.localize);
    return DrivePath(robot_, localizer, {path, {}, {}, {}}, options, {});
  }

  drivers::SimulatedRobot robot_{TwoRoomsScene(), RobotOptions(), 3};
  slam::ScannerModel scanner_ = drivers::AisMounting(RobotOptions().ais).scanner;
};

TEST_F(DrivePathTest, ArrivesWhereTheMapSaysAndNotWhereTheWheelsSay) {
  const slam::AlignModel model = ModelOfFirstScan();
  const Eigen::Vector2d start = robot_.T_map_base_true().translation;
  std::vector<slam::Pose2> path = Straight(start, {4.0, 2.5});
  for (int turn = 1; turn <= 20; ++turn) path.push_back({slam::WrapAngle(0.15 * turn), {4.0, 2.5}});
  const DriveReport report = Drive(path, &model);
  EXPECT_EQ(report.end, DriveEnd::kArrived);
  EXPECT_NEAR(report.length, 2.5, 0.1);
  const slam::Pose2 off = report.poses_map.back().Inverse() * robot_.T_map_base_true();
  EXPECT_LT(off.translation.norm(), 0.03);
  EXPECT_LT(std::abs(off.angle), 0.03) << "3 % of 3 rad are 0.09";
  const slam::Pose2::Tangent error = off.Log();
  EXPECT_LT(error.dot(report.covariance.inverse() * error), 11.3) << "of chi-square of 3, at 99 %";
  EXPECT_LT(report.covariance.diagonal().cwiseSqrt().maxCoeff(), 0.05) << "but it knows something";

  drivers::SimulatedRobot blind(TwoRoomsScene(), RobotOptions(), 3);
  const Localizer odometry(blind, blind.T_map_base_true(), nullptr, scanner_, {});
  const DriveReport by_wheels = DrivePath(blind, odometry, {path, {}, {}, {}}, {}, {});
  const slam::Pose2 erred = by_wheels.poses_map.back().Inverse() * blind.T_map_base_true();
  EXPECT_GT(std::abs(erred.angle), 0.05);
}

TEST_F(DrivePathTest, StandsBeforeAWallThatThePathLeadsThrough) {
  const DriveReport report = Drive(Straight(robot_.T_map_base_true().translation, {1.5, 6.0}), nullptr);
  EXPECT_EQ(report.end, DriveEnd::kBlocked);
  EXPECT_EQ(robot_.collisions().size(), 0U);
  ASSERT_EQ(report.obstacles_map.size(), 1U);
  EXPECT_EQ(robot_.State().velocity.forward, 0.0);
}

TEST_F(DrivePathTest, KeepsFromWhatOnlyTheMapKnowsAsMuchAsThePathDoes) {
  const Eigen::Vector2d start = robot_.T_map_base_true().translation, goal(4.0, 2.5);
  const Eigen::Vector2d ahead = (goal - start).normalized(), left(-ahead.y(), ahead.x());
  constexpr double kHalfGate = 0.3 + 0.035;  // half the robot's width, and 3.5 cm
  const Eigen::Vector2d gate = start + 1.5 * ahead;
  const std::vector<Eigen::Vector2d> posts{gate + kHalfGate * left, gate - kHalfGate * left};
  const std::vector<slam::Pose2> path = Straight(start, goal);
  const auto drive = [&](double margin, std::size_t retraced = 0) {
    drivers::SimulatedRobot robot(TwoRoomsScene(), RobotOptions(), 3);
    robot.Drive({0.0, 0.3});  // to look along the path
    const double angle = std::atan2(ahead.y(), ahead.x());
    while (std::abs(slam::WrapAngle(robot.T_map_base_true().angle - angle)) > 0.02)
      robot.Drive({0.0, 0.3}), robot.WaitUntil(robot.Now() + 0.01);
    robot.Drive({});
    robot.WaitUntil(robot.Now() + 1.0);
    const Localizer localizer(robot, robot.T_map_base_true(), nullptr, scanner_, {});
    return DrivePath(robot, localizer, {path, {}, {}, posts, margin, retraced}, {}, {});
  };
  const DriveReport passed = drive(0.02), held = drive(0.08);
  EXPECT_EQ(passed.end, DriveEnd::kArrived);
  EXPECT_FALSE(passed.held_map);
  EXPECT_EQ(held.end, DriveEnd::kBlocked);
  ASSERT_TRUE(held.held_map);
  EXPECT_TRUE(std::ranges::any_of(posts, [&](const Eigen::Vector2d& post) {
    return (*held.held_map - post).norm() < 0.15;
  })) << "one of the posts, as near as it may be";
  EXPECT_EQ(drive(0.08, path.size()).end, DriveEnd::kArrived) << "where it has been, the map errs";
  EXPECT_EQ(drive(0.08, 2 * path.size()).end, DriveEnd::kArrived) << "the path is cut before its end";
  EXPECT_EQ(drive(0.08, path.size() / 4).end, DriveEnd::kBlocked) << "the gate is beyond";
}

TEST_F(DrivePathTest, GoesStraightBackWhereTheLeastTurnIsBarred) {
  const slam::Pose2 start = robot_.T_map_base_true();
  const std::vector<Eigen::Vector2d> posts{start * Eigen::Vector2d(0.35, -0.38)};  // beside the nose
  std::vector<slam::Pose2> path;
  for (int i = 0; i <= 20; ++i)
    path.push_back(start * slam::Pose2{0.0, {-0.04 * i, std::min(0.04, 0.01 * i)}});
  const Localizer localizer(robot_, start, nullptr, robot_.TakeScan().scanner, {});
  const DriveReport report = DrivePath(robot_, localizer, {path, {}, {}, posts}, {}, {});
  EXPECT_EQ(report.end, DriveEnd::kArrived) << report.reason;
}

TEST_F(DrivePathTest, ContactIsLeftByTheWayThatItCame) {
  DriveOptions options;
  options.avoid_obstacles = false;
  const DriveReport report =
      Drive(Straight(robot_.T_map_base_true().translation, {1.5, -1.0}), nullptr, options);
  EXPECT_EQ(report.end, DriveEnd::kBlocked);
  EXPECT_EQ(robot_.collisions().size(), 1U);
  ASSERT_EQ(report.obstacles_map.size(), 1U);
  EXPECT_NEAR(report.obstacles_map[0].y(), 0.06, 0.15);  // the wall's face
  EXPECT_FALSE(robot_.State().blocked);
  EXPECT_GT(robot_.T_map_base_true().translation.y(), 0.06 + 0.4 + 0.3);
}

}  // namespace
}  // namespace ariadne::experiments
