#include "experiments/exploration/explore_3d.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/simulated/plan_world.h"
#include "experiments/exploration/robot_drive.h"
#include "experiments/exploration/scan_loop_world.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

/// Two rooms of 3.5 m x 4 m with an opening of 1.4 m between them; stubs of wall tell their ends apart.
drivers::World TwoRooms() {
  drivers::PlanOptions plan;
  plan.thickness = 0.3;
  return drivers::ParsePlan(
      R"({"walls": [[0, 0, 7, 0], [7, 0, 7, 4], [7, 4, 0, 4], [0, 4, 0, 0], [3.5, 0, 3.5, 1.3],
                    [3.5, 2.7, 3.5, 4], [0.8, 4, 0.8, 3.4], [5.8, 0, 5.8, 0.7]],
          "doors": [], "start": [1.5, 2], "spaces": []})",
      "two rooms", plan);
}

/// Wheels without errors: half circles of small rooms overlap too little to mend what a large error spoils.
Explore3dOptions Quick() {
  Explore3dOptions options;
  options.robot.base.wheels.radius_spread = 0.0;
  options.robot.base.wheels.track_spread = 0.0;
  options.robot.base.wheels.slip = 0.0;
  options.mapper.icp.max_distance = 0.1;
  options.mapper.icp.start_distance = 0.1;
  options.robot.ais.slices = 64;
  options.robot.safety.installed = false;  // nothing moves in these rooms
  options.area.polygon.slice.half_thickness = 0.1;
  options.planner.candidates.count = 60;
  options.planner.min_overlap = 0.3;  // bare rooms look alike from several poses
  options.max_scans = 16;
  return options;
}

ScanLoopWorld PreparedRooms() {
  ScanLoopWorldOptions options;
  options.reach_step = 0.2;
  return PrepareScanLoopWorld(TwoRooms(), Quick(), options, Parallel(1));
}

TEST(Explore3d, SeesTwoRoomsAndEnds) {
  const ScanLoopWorld world = PreparedRooms();
  const Exploration3d exploration = Explore3d(world.scene, world.floor, Quick(), 1);
  EXPECT_TRUE(exploration.ended || exploration.steps.size() == 16u);
  EXPECT_EQ(exploration.refused, 0);
  ASSERT_GE(exploration.steps.size(), 2u);
  for (std::size_t i = 1; i < exploration.steps.size(); ++i) {
    EXPECT_GE(exploration.steps[i].covered, exploration.steps[i - 1].covered);
    EXPECT_GE(exploration.steps[i].path, exploration.steps[i - 1].path);
  }
  EXPECT_LT(exploration.steps.front().covered, 0.7);
  EXPECT_GT(exploration.steps.back().covered, 0.95);
  EXPECT_GT(exploration.steps.back().mapped, 0.85);
  EXPECT_EQ(exploration.scans.size(), exploration.steps.size());
  EXPECT_LE(ScansTo(exploration, 0.9), static_cast<double>(exploration.steps.size()));
  EXPECT_TRUE(std::isinf(ScansTo(exploration, 1.1)));
  EXPECT_TRUE(std::isinf(PathTo(exploration, 1.1)));

  const ScanLoopVerdict verdict = JudgeExploration(exploration, world, Parallel(1));
  EXPECT_GT(verdict.surface_covered, 0.9);
  EXPECT_LT(verdict.translation_rms, 0.05);
  EXPECT_LT(verdict.map_error_95, 0.05);
}

TEST(Explore3d, IsTheSameForTheSameSeedAndAnyThreads) {
  const ScanLoopWorld world = PreparedRooms();
  Explore3dOptions options = Quick();
  options.max_scans = 3;
  const Exploration3d one = Explore3d(world.scene, world.floor, options, 5);
  options.robot.threads = 2;
  options.mapper.icp.threads = 2;
  const Exploration3d two = Explore3d(world.scene, world.floor, options, 5);
  const Exploration3d other = Explore3d(world.scene, world.floor, options, 6);
  ASSERT_EQ(one.steps.size(), two.steps.size());
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].T_map_base.angle, two.steps[i].T_map_base.angle);
    EXPECT_EQ(one.steps[i].T_map_base.translation, two.steps[i].T_map_base.translation);
    EXPECT_EQ(one.steps[i].T_map_base_true.translation, two.steps[i].T_map_base_true.translation);
    EXPECT_EQ(one.steps[i].mapped, two.steps[i].mapped);
  }
  EXPECT_NE(one.steps[1].T_map_base_true.translation, other.steps[1].T_map_base_true.translation);
}

TEST(Explore3d, StopsAfterTheScansThatAreAllowed) {
  const ScanLoopWorld world = PreparedRooms();
  Explore3dOptions options = Quick();
  options.max_scans = 1;
  const Exploration3d exploration = Explore3d(world.scene, world.floor, options, 1);
  EXPECT_EQ(exploration.steps.size(), 1u);
  EXPECT_FALSE(exploration.ended);
  EXPECT_EQ(exploration.steps[0].path, 0.0);
}

TEST(Explore3d, RefusesHeightsThatAreNoNumbers) {
  const ScanLoopWorld world = PreparedRooms();
  Explore3dOptions options = Quick();
  options.heights = "1.5, high";
  EXPECT_THROW(Explore3d(world.scene, world.floor, options, 1), Error);
}

drivers::SimulatedRobot RobotInRooms(bool exact) {
  drivers::SimulatedRobotOptions options;
  if (exact) {
    options.base.wheels.radius_spread = 0.0;
    options.base.wheels.track_spread = 0.0;
    options.base.wheels.slip = 0.0;
  }
  return {std::make_shared<const drivers::RayScene>(TwoRooms()), options, 3};
}

slam::Pose2 StartOdometry(drivers::SimulatedRobot& robot) {
  return robot.T_map_base_true() * robot.State().odometry.T_odom_base.Inverse();
}

TEST(DriveWay, GetsThereByOdometry) {
  drivers::SimulatedRobot robot = RobotInRooms(true);
  const std::vector<Eigen::Vector2d> way{{1.5, 2.0}, {5.0, 2.0}, {5.5, 3.0}};
  const DriveOutcome outcome = DriveWay(robot, StartOdometry(robot), way, slam::RadFromDeg(180.0));
  EXPECT_FALSE(outcome.blocked);
  EXPECT_LT((robot.T_map_base_true().translation - way.back()).norm(), 0.05);
  EXPECT_LT(std::abs(slam::WrapAngle(robot.T_map_base_true().angle - slam::RadFromDeg(180.0))), 0.02);
}

TEST(DriveWay, ErrsByWhatItTakesItselfToBeWrong) {
  drivers::SimulatedRobot robot = RobotInRooms(true);
  const slam::Pose2 wrong = slam::Pose2{0.0, {0.3, -0.2}} * StartOdometry(robot);
  DriveWay(robot, wrong, std::vector<Eigen::Vector2d>{{2.5, 2.0}}, 0.0);
  EXPECT_LT((robot.T_map_base_true().translation - Eigen::Vector2d(2.2, 2.2)).norm(), 0.05);
}

TEST(DriveWay, StopsAtAWallAndSaysWhereItIs) {
  drivers::SimulatedRobot robot = RobotInRooms(true);
  const DriveOutcome outcome =
      DriveWay(robot, StartOdometry(robot), std::vector<Eigen::Vector2d>{{1.5, 5.0}}, 0.0);
  EXPECT_TRUE(outcome.blocked);
  EXPECT_EQ(robot.collisions(), 1);
  ASSERT_TRUE(outcome.contact_map);
  EXPECT_NEAR(outcome.contact_map->y(), 3.85, 0.12);                // the wall's face
  EXPECT_NEAR(robot.T_map_base_true().translation.y(), 3.25, 0.1);  // half its length and 20 cm before it
  EXPECT_FALSE(
      DriveWay(robot, StartOdometry(robot), std::vector<Eigen::Vector2d>{{1.5, 2.0}}, 0.0).blocked);
}

}  // namespace
}  // namespace ariadne::experiments
