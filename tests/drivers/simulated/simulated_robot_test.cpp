#include "drivers/simulated/simulated_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {
namespace {

std::shared_ptr<const RayScene> SceneOf(World world) {
  return std::make_shared<RayScene>(std::move(world));
}

/// 181 x 32 points, which is enough here.
SimulatedRobotOptions Small() {
  SimulatedRobotOptions options;
  options.ais.slices = 32;
  options.ais.range_finder.mixed_pixels = false;
  return options;
}

SimulatedRobotOptions RobotWithoutErrors() {
  SimulatedRobotOptions options = Small();
  options.base.wheels.radius_spread = options.base.wheels.track_spread = options.base.wheels.slip = 0.0;
  options.ais.range_finder = WithoutErrors(options.ais.range_finder);
  options.safety.range_finder = WithoutErrors(options.safety.range_finder);
  return options;
}

/// A person-sized post that crosses the room in front of the robot between two times.
World RoomWithWalker(double from_time, double to_time) {
  World world = FurnishedRoom();
  Body walker = BoxBody("walker", {-0.15, -0.15, 0.0}, {0.15, 0.15, 1.8});
  walker.motion = {{from_time, to_time},
                   {slam::ToPose3({0.0, {2.5, -2.5}}), slam::ToPose3({0.0, {2.5, 2.5}})}};
  world.bodies.push_back(walker);
  return world;
}

void AppendBytes(std::string& bytes, const slam::LaserSweep& sweep) {
  const auto add = [&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  for (const double number : {sweep.stamp, sweep.pitch, sweep.pitch_rate}) add(&number, sizeof number);
  add(sweep.ranges.data(), sweep.ranges.size() * sizeof(float));
  add(sweep.reflectance.data(), sweep.reflectance.size() * sizeof(float));
}

/// What a mission sees of a short drive, byte by byte.
std::string BytesOfAMission(Robot& robot) {
  std::string bytes;
  for (int stop = 0; stop < 2; ++stop) {
    for (const slam::LaserSweep& sweep : robot.TakeScan().sweeps) AppendBytes(bytes, sweep);
    robot.Drive({0.5, 0.3});
    robot.WaitUntil(robot.Now() + 1.0);
    AppendBytes(bytes, robot.TakeSweep());
    for (const SafetySweep& safety : robot.TakeSafetySweeps()) AppendBytes(bytes, safety.sweep);
    const slam::Odometry odometry = robot.State().odometry;
    bytes.append(reinterpret_cast<const char*>(odometry.covariance.data()), 9 * sizeof(double));
    bytes.append(reinterpret_cast<const char*>(odometry.T_odom_base.translation.data()),
                 2 * sizeof(double));
  }
  return bytes;
}

TEST(SimulatedRobot, TakesItsTimeForAScan) {
  SimulatedRobotOptions options;
  options.ais.range_finder.mixed_pixels = false;
  SimulatedRobot robot(SceneOf(FurnishedRoom()), options, 1);
  robot.WaitUntil(2.0);
  const slam::Scan scan = robot.TakeScan();
  EXPECT_EQ(scan.sweeps.size(), 256u);
  EXPECT_EQ(scan.sweeps.front().stamp, 2.0);
  EXPECT_NEAR(robot.Now(), 2.0 + 3.41, 0.01);
  EXPECT_EQ(robot.repeated_scans(), 0);
}

TEST(SimulatedRobot, StandsWhileItScans) {
  SimulatedRobot robot(SceneOf(FurnishedRoom()), Small(), 1);
  robot.Drive({0.5, 0.0});
  robot.WaitUntil(2.0);
  const slam::Scan scan = robot.TakeScan();
  EXPECT_NEAR(scan.sweeps.front().stamp, 2.0 + 0.5 / 0.5, 1e-9) << "after braking";
  EXPECT_EQ(robot.State().velocity.forward, 0.0);
  EXPECT_EQ(scan.odometry.T_odom_base.translation, robot.State().odometry.T_odom_base.translation);
  EXPECT_EQ(scan.odometry.covariance, robot.State().odometry.covariance);
}

TEST(SimulatedRobot, SeesTheWorldFromWhereItTrulyIs) {
  SimulatedRobot robot(SceneOf(EmptyRoom({-4, -3, 0}, {4, 3, 2.7})), RobotWithoutErrors(), 1);
  robot.Drive({0.5, 0.1});
  robot.WaitUntil(3.0);
  const slam::Scan scan = robot.TakeScan();
  const slam::Pose3 T_map_laser = slam::ToPose3(robot.T_map_base_true()) * robot.T_base_laser();
  const slam::Box3 room(Eigen::Vector3d(-4, -3, 0), Eigen::Vector3d(4, 3, 2.7));
  for (const Eigen::Vector3d& p_laser : ToPointCloud(scan).positions) {
    const Eigen::Vector3d p = T_map_laser * p_laser;
    EXPECT_LT(std::min((p - room.min()).cwiseAbs().minCoeff(), (p - room.max()).cwiseAbs().minCoeff()),
              1e-4);
  }
}

TEST(SimulatedRobot, SweepsOnItsWay) {
  SimulatedRobot robot(SceneOf(EmptyRoom({-4, -3, 0}, {4, 3, 2.7})), RobotWithoutErrors(), 1);
  robot.Drive({0.8, 0.0});
  robot.WaitUntil(3.0);
  const slam::LaserSweep sweep = robot.TakeSweep();
  const double duration = 1.0 / 75.0;
  EXPECT_NEAR(sweep.stamp, 3.0 - duration, 1e-12);
  EXPECT_EQ(robot.Now(), 3.0) << "that costs no time";
  // Beam 90 looks ahead, a quarter of a turn after the stamp.
  const double then = robot.T_map_base_true().translation.x() - 0.8 * 0.75 * duration;
  EXPECT_NEAR(sweep.ranges[90], 4.0 - then - robot.T_base_laser().translation.x(), 1e-4);
}

TEST(SimulatedRobot, LooksAheadAndBack) {
  SimulatedRobot robot(SceneOf(EmptyRoom({-4, -3, 0}, {4, 3, 2.7})), RobotWithoutErrors(), 1);
  robot.WaitUntil(1.0);
  const auto sweeps = robot.TakeSafetySweeps();
  ASSERT_EQ(sweeps.size(), 2u);
  for (const SafetySweep& safety : sweeps) {
    EXPECT_NEAR(safety.sweep.ranges[safety.sweep.ranges.size() / 2], 3.6, 1e-4);
  }
}

TEST(SimulatedRobot, RepeatsAScanInWhichSomebodyWalked) {
  SimulatedRobotOptions options = Small();
  options.ais.slices = 128;  // 1.7 s
  SimulatedRobot robot(SceneOf(RoomWithWalker(0.0, 4.0)), options, 1);
  const slam::Scan scan = robot.TakeScan();
  EXPECT_GE(robot.repeated_scans(), 2);
  EXPECT_GE(scan.sweeps.front().stamp, 3.0) << "until the walker stands";
  EXPECT_LT(robot.repeated_scans(), options.frames.max_repeats);
}

TEST(SimulatedRobot, LosesPatience) {
  SimulatedRobotOptions options = Small();
  options.frames.max_repeats = 2;
  options.ais.slices = 128;
  SimulatedRobot robot(SceneOf(RoomWithWalker(0.0, 10.0)), options, 1);
  robot.TakeScan();
  EXPECT_EQ(robot.repeated_scans(), 2);
}

TEST(SimulatedRobot, GivesTheSameBytesWithOneThreadAndWithTwo) {
  const auto scene = SceneOf(RoomWithWalker(1.0, 6.0));
  const auto bytes = [&](int threads, std::uint64_t seed) {
    SimulatedRobotOptions options = Small();
    options.threads = threads;
    SimulatedRobot robot(scene, options, seed);
    return BytesOfAMission(robot);
  };
  const std::string once = bytes(1, 1);
  EXPECT_TRUE(once == bytes(1, 1));
  EXPECT_TRUE(once == bytes(2, 1));
  EXPECT_FALSE(once == bytes(1, 2));
}

/// Skipping is measuring without the result: afterwards both robots measure the same.
TEST(SimulatedRobot, IsTheSameAfterWhatItSkips) {
  const auto scene = SceneOf(RoomWithWalker(0.0, 4.0));
  SimulatedRobotOptions options = Small();
  options.ais.slices = 96;
  SimulatedRobot one(scene, options, 1), other(scene, options, 1);
  for (SimulatedRobot* robot : {&one, &other}) {
    robot->Drive({0.4, 0.2});
    robot->WaitUntil(0.5);
  }
  one.TakeScan(), one.TakeSweep(), one.TakeSafetySweeps();
  other.SkipScan(), other.SkipSweep(), other.SkipSafetySweeps();
  EXPECT_GT(one.repeated_scans(), 0);
  EXPECT_EQ(one.repeated_scans(), other.repeated_scans());
  EXPECT_EQ(one.Now(), other.Now());
  EXPECT_TRUE(BytesOfAMission(one) == BytesOfAMission(other));
  EXPECT_EQ(one.path_true().size(), other.path_true().size());
}

TEST(SimulatedRobot, DrivesTheSameWayWhateverItsScannersDo) {
  const auto scene = SceneOf(FurnishedRoom());
  SimulatedRobotOptions blind = RobotWithoutErrors();
  blind.base = {};
  SimulatedRobot one(scene, Small(), 3), other(scene, blind, 3);
  for (SimulatedRobot* robot : {&one, &other}) BytesOfAMission(*robot);
  EXPECT_EQ(one.T_map_base_true().translation, other.T_map_base_true().translation);
  EXPECT_EQ(one.T_map_base_true().angle, other.T_map_base_true().angle);
}

TEST(SimulatedRobot, IsStoppedByTheWall) {
  SimulatedRobot robot(SceneOf(FurnishedRoom()), Small(), 1);
  robot.Drive({-0.8, 0.0});
  robot.WaitUntil(10.0);
  EXPECT_EQ(robot.collisions().size(), 1U);
  EXPECT_TRUE(robot.State().blocked);
  EXPECT_EQ(robot.path_true().back().T_map_base.translation, robot.T_map_base_true().translation);
}

}  // namespace
}  // namespace ariadne::drivers
