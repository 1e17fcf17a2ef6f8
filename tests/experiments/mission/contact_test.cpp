#include "experiments/mission/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "drivers/simulated/simulated_robot.h"
#include "drivers/simulated/surface_distance.h"
#include "tests/drivers/emulated/robot/robot_bench.h"

namespace ariadne::experiments {
namespace {

using drivers::RobotState;
using drivers::SafetySweep;

/// Wide, so that an angle that errs shows.
drivers::World Hall() { return drivers::EmptyRoom({-8, -6, 0}, {8, 6, 2.7}); }

/// How far what sweeps saw is from the walls at the most, seen from where the robot truly is [m].
double WorstOf(const std::vector<SafetySweep>& sweeps, const RobotState& now,
               const slam::Pose2& T_map_base) {
  const drivers::World world = Hall();
  const drivers::SurfaceDistance walls(world);
  double worst = 0.0;
  for (const SafetySweep& sweep : sweeps) {
    for (const Eigen::Vector3d& p_base : PointsOf(sweep, now))
      worst = std::max(worst, walls.Closest(slam::ToPose3(T_map_base) * p_base).distance);
  }
  return worst;
}

/// As if all of each sweep was of now.
double WorstAtOnce(std::vector<SafetySweep> sweeps, RobotState now, const slam::Pose2& T_map_base) {
  now.velocity = {};
  return WorstOf(sweeps, now, T_map_base);
}

/// Between the steps of a base.
slam::Pose2 TruthAt(const drivers::SimulatedBase& base, double time) {
  const auto after = std::ranges::lower_bound(base.path_true(), time, {}, &drivers::TruePose::time);
  const auto before = after - 1;
  const slam::Pose2 step = before->T_map_base.Inverse() * after->T_map_base;
  const double share = (time - before->time) / (after->time - before->time);
  return before->T_map_base * slam::Pose2::Exp(share * step.Log());
}

drivers::SimulatedRobotOptions ExactRobot() {
  drivers::SimulatedRobotOptions options;
  options.ais.range_finder = WithoutErrors(options.ais.range_finder);
  options.safety.range_finder = WithoutErrors(options.safety.range_finder);
  return options;
}

/// A sweep takes a while, in which who turns has turned.
TEST(LookAround, TellsBeamsOfWhoTurnsWhereTheThingsAreNow) {
  const auto scene = std::make_shared<const drivers::RayScene>(Hall());
  for (const bool safety : {true, false}) {
    drivers::SimulatedRobotOptions options = ExactRobot();
    options.safety.installed = safety;
    drivers::SimulatedRobot robot(scene, options, 1);
    const slam::ScannerModel scanner = robot.TakeScan().scanner;
    for (double time = robot.Now(), end = time + 2.0; time < end; robot.WaitUntil(time += 0.05))
      robot.Drive({0.3, 0.6});
    const std::vector<SafetySweep> sweeps = LookAround(robot, scanner);
    ASSERT_EQ(sweeps.size(), safety ? 3U : 1U);
    EXPECT_LT(WorstOf(sweeps, robot.State(), robot.T_map_base_true()), 0.007);  // centimetres
    EXPECT_GT(WorstAtOnce(sweeps, robot.State(), robot.T_map_base_true()), 0.03);
  }
}

/// The scanner of a real robot streams: its newest sweep is of some time ago.
TEST(LookAround, TellsOldSweepsOfARealRobotWhereTheThingsAreNow) {
  drivers::RobotBench bench(Hall());
  bench.robot->Connect();
  double worst = 0.0, at_once = 0.0;
  for (int i = 0; i < 20; ++i) {
    bench.DriveFor({0.3, 0.6}, i == 0 ? 2.0 : 0.05);
    const std::vector<SafetySweep> sweeps = LookAround(*bench.robot, bench.robot->scanner().scanner());
    const RobotState now = bench.robot->State();
    const slam::Pose2 T_map_base = TruthAt(bench.device.base(), now.stamp);
    worst = std::max(worst, WorstOf(sweeps, now, T_map_base));
    at_once = std::max(at_once, WorstAtOnce(sweeps, now, T_map_base));
  }
  EXPECT_LT(worst, 0.007);
  EXPECT_GT(at_once, 0.09);
}

}  // namespace
}  // namespace ariadne::experiments
