#include "drivers/replay/continued_robot.h"

#include <gtest/gtest.h>

#include "drivers/replay/replay_robot.h"
#include "drivers/simulated/simulated_robot.h"
#include "tests/drivers/replay/scripted_robot.h"
#include "tests/drivers/replay/simulation.h"
#include "tests/slam/io/support.h"

namespace ariadne::drivers {
namespace {

using slam::Pose2;

LastKnown SomeEnd() {
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.0025;
  return {123.4, slam::Odometry{{2.5, {3.0, -1.0}}, covariance}};
}

void ExpectNear(const Pose2& a, const Pose2& b) {
  EXPECT_LT((a.translation - b.translation).norm(), 1e-12);
  EXPECT_LT(std::abs((a.Inverse() * b).angle), 1e-12);
}

TEST(ContinuedRobot, BeginsWhereTheLogEnds) {
  ScriptedRobot live;
  live.state.stamp = 7.0;
  live.state.odometry.T_odom_base = {-1.0, {5.0, 6.0}};
  ContinuedRobot robot(live, SomeEnd());
  EXPECT_DOUBLE_EQ(robot.Now(), 123.4);
  const RobotState state = robot.State();
  EXPECT_DOUBLE_EQ(state.stamp, 123.4);
  ExpectNear(state.odometry.T_odom_base, SomeEnd().odometry->T_odom_base);
  EXPECT_TRUE(state.odometry.covariance.isApprox(SomeEnd().odometry->covariance, 1e-12));
}

/// Wherever the live odometry has begun, the same way is seen.
TEST(ContinuedRobot, GoesOnByTheSameWayInAnyOdometry) {
  const Pose2 T_first_later{0.7, {0.4, -0.2}};
  for (const Pose2& T_odom_first : {Pose2{}, Pose2{3.0, {100.0, -20.0}}, Pose2{-1.2, {0.3, 0.1}}}) {
    ScriptedRobot live;
    live.state.stamp = 50.0;
    live.state.odometry.T_odom_base = T_odom_first;
    ContinuedRobot robot(live, SomeEnd());
    live.state.stamp = 52.0;
    live.state.odometry.T_odom_base = T_odom_first * T_first_later;
    ExpectNear(robot.State().odometry.T_odom_base, SomeEnd().odometry->T_odom_base * T_first_later);
    const slam::Scan scan = robot.TakeScan();
    ExpectNear(scan.odometry.T_odom_base, SomeEnd().odometry->T_odom_base * T_first_later);
    for (const slam::LaserSweep& sweep : scan.sweeps) EXPECT_DOUBLE_EQ(sweep.stamp, 125.4);
    EXPECT_DOUBLE_EQ(robot.TakeSweep().stamp, 125.4);
    EXPECT_DOUBLE_EQ(robot.TakeSafetySweeps().front().sweep.stamp, 125.4);
  }
}

/// An error xi of the log's end moves the later pose by J xi; J by differences.
TEST(ContinuedRobot, CarriesTheCovarianceAlong) {
  const Pose2 T_first_later{0.7, {2.0, -1.0}};
  Eigen::Matrix3d J;
  for (int i = 0; i < 3; ++i) {
    const Pose2 moved = Pose2::Exp(1e-6 * Eigen::Vector3d::Unit(i)) * T_first_later;
    J.col(i) = (T_first_later.Inverse() * moved).Log() / 1e-6;
  }
  ScriptedRobot live;
  ContinuedRobot robot(live, SomeEnd());
  live.state.odometry = {T_first_later, Eigen::Matrix3d::Identity() * 1e-4};
  const Eigen::Matrix3d expected =
      J * SomeEnd().odometry->covariance * J.transpose() + Eigen::Matrix3d::Identity() * 1e-4;
  EXPECT_TRUE(robot.State().odometry.covariance.isApprox(expected, 1e-5));
}

TEST(ContinuedRobot, WaitsLongEnoughInSpiteOfRounding) {
  RandomStream stream = NamedStream(1, "offsets");
  for (int trial = 0; trial < 1000; ++trial) {
    ScriptedRobot live;
    live.state.stamp = DrawUniform(stream, 0.0, 1e5);
    ContinuedRobot robot(live, {DrawUniform(stream, 0.0, 1e3), {}});
    const double until = robot.Now() + DrawUniform(stream, 0.0, 0.1);
    robot.WaitUntil(until);
    EXPECT_GE(robot.Now(), until);
    EXPECT_LT(robot.Now(), until + 1e-9);
  }
}

TEST(ContinuedRobot, KeepsTheLiveRobotsOwnWhereTheLogKnowsNothing) {
  ScriptedRobot live;
  live.state.stamp = 7.0;
  live.state.odometry.T_odom_base = {-1.0, {5.0, 6.0}};
  ContinuedRobot robot(live, {});
  EXPECT_EQ(robot.Now(), 7.0);
  ExpectNear(robot.State().odometry.T_odom_base, {-1.0, {5.0, 6.0}});
}

/// A mission of which the second half is driven by a robot that was switched on there.
TEST(ContinuedRobot, IsTakenOnByAReplay) {
  const slam::testing_support::TemporaryFolder folder;
  const auto path = folder / "robot.log";
  {
    RobotLogWriter log(path);
    for (const RobotCall& call : std::vector<RobotCall>{
             NowCall{10.0}, DriveCall{{0.2, 0.0}}, WaitCall{11.5},
             StateCall{{11.5, {{1.0, {2.0, 3.0}}, Eigen::Matrix3d::Identity()}, {}, false}}}) {
      log.Append(call);
    }
  }
  RobotLog log = ReadRobotLog(path);
  RobotLogWriter more(path);
  ScriptedRobot live;
  ReplayRobot robot(log, {[&]() -> Robot& { return live; }, Seam::kRestarted, &more});
  EXPECT_EQ(robot.Now(), 10.0);
  robot.Drive({0.2, 0.0});
  robot.WaitUntil(11.5);
  robot.State();
  EXPECT_FALSE(robot.Replayed());
  EXPECT_EQ(robot.Now(), 11.5);
  robot.WaitUntil(12.0);
  EXPECT_EQ(live.state.stamp, 0.5);
  EXPECT_TRUE(live.told.empty()) << "what was on the log is not driven again";
  live.state.odometry.T_odom_base = {0.0, {0.1, 0.0}};
  const RobotState state = robot.State();
  ExpectNear(state.odometry.T_odom_base, Pose2{1.0, {2.0, 3.0}} * Pose2{0.0, {0.1, 0.0}});

  RobotLog whole = ReadRobotLog(path);  // in which nobody sees the seam
  ASSERT_EQ(whole.size(), 7U);
  EXPECT_EQ(EncodeCall(whole.Read(6)), EncodeCall(StateCall{state}));
  EXPECT_EQ(EncodeCall(whole.Read(5)), EncodeCall(WaitCall{12.0}));
}

}  // namespace
}  // namespace ariadne::drivers
