#include "experiments/mission/beside_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/simulated/sweep_beams.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;

/// What a scanner at x on the base that looks ahead or behind sees of places around the robot.
drivers::SafetySweep SweepOf(double x, double heading, const std::vector<Vector2d>& places_base) {
  drivers::SafetySweep sweep;
  sweep.T_base_laser = slam::ToPose3(slam::Pose2{heading, {x, 0.0}});
  sweep.scanner = drivers::HalfCircle(2);
  sweep.sweep.ranges.assign(361, slam::LaserSweep::kNoReturn);
  for (const Vector2d& p_base : places_base) {
    const Vector2d p = slam::Pose2{heading, {x, 0.0}}.Inverse() * p_base;
    const double beam = (std::atan2(p.x(), -p.y()) - sweep.scanner.first_angle) / sweep.scanner.angle_step;
    if (beam < 0.0 || beam > 360.0) continue;
    sweep.sweep.ranges[static_cast<std::size_t>(std::lround(beam))] = static_cast<float>(p.norm());
  }
  return sweep;
}

/// Both scanners, and one place of the world.
std::vector<drivers::SafetySweep> Look(const slam::Pose2& T_odom_base,
                                       const std::vector<Vector2d>& places_odom) {
  std::vector<Vector2d> places_base;
  for (const Vector2d& p_odom : places_odom) places_base.push_back(T_odom_base.Inverse() * p_odom);
  return {SweepOf(0.4, 0.0, places_base), SweepOf(-0.4, std::numbers::pi, places_base)};
}

drivers::RobotState At(const slam::Pose2& T_odom_base) {
  drivers::RobotState state;
  state.odometry.T_odom_base = T_odom_base;
  return state;
}

TEST(BesideMemory, KnowsWhatTheRobotPasses) {
  BesideMemory memory;
  const Vector2d post_odom(2.007, 0.5);
  for (double x = 0.0; x <= 4.0; x += 0.02) {
    const slam::Pose2 T_odom_base{0.0, {x, 0.0}};
    const std::vector<Vector2d> points = memory.Update(Look(T_odom_base, {post_odom}), At(T_odom_base));
    ASSERT_FALSE(points.empty()) << x;  // seen ahead, remembered beside, seen behind
    for (const Vector2d& p_base : points) EXPECT_LT((T_odom_base * p_base - post_odom).norm(), 0.02);
  }
}

TEST(BesideMemory, BelievesWhatItSees) {
  BesideMemory memory;
  const slam::Pose2 before{0.0, {1.2, 0.0}}, beside{0.0, {1.8, 0.0}}, back{0.0, {1.3, 0.0}};
  EXPECT_FALSE(memory.Update(Look(before, {{2.0, 0.5}}), At(before)).empty());
  EXPECT_FALSE(memory.Update(Look(beside, {}), At(beside)).empty());  // it cannot know
  EXPECT_TRUE(memory.Update(Look(back, {}), At(back)).empty());       // ahead again, and gone
  EXPECT_TRUE(memory.Update(Look(beside, {}), At(beside)).empty());
}

TEST(BesideMemory, KnowsWhatAScannerLooksOver) {
  BesideMemory memory;
  const slam::Pose2 before{0.0, {1.2, 0.0}}, beside{0.0, {1.8, 0.0}};
  EXPECT_FALSE(memory.Update(Look(before, {{2.0, 0.5}}), At(before)).empty());
  std::vector<drivers::SafetySweep> over = Look(beside, {});
  over.push_back(SweepOf(0.0, 0.0, {}));
  over.back().T_base_laser.translation.z() = 0.9;
  EXPECT_FALSE(memory.Update(over, At(beside)).empty());
  over.back().T_base_laser.translation.z() = 0.0;
  EXPECT_TRUE(memory.Update(over, At(beside)).empty());
}

TEST(BesideMemory, KeepsWhatIsAtTheEdgeOfItsViewOnce) {
  BesideMemory memory;
  std::size_t most = 0;
  for (int i = 0; i < 100; ++i) {  // the scanner's noise shifts it in and out of view
    const Vector2d post(0.4 + (i % 2 == 0 ? 0.003 : -0.003), 0.5);
    most = std::max(most, memory.Update(Look({}, {post}), At({})).size());
  }
  EXPECT_LE(most, 2U);
}

TEST(BesideMemory, ForgetsWhatIsFarAndDoesNotGrow) {
  BesideMemory memory;
  std::vector<Vector2d> wall_odom;
  for (double x = 0.0; x < 30.0; x += 0.1) wall_odom.emplace_back(x, 0.6);
  std::size_t most = 0;
  for (double x = 0.0; x <= 20.0; x += 0.05) {
    const slam::Pose2 T_odom_base{0.0, {x, 0.0}};
    most = std::max(most, memory.Update(Look(T_odom_base, wall_odom), At(T_odom_base)).size());
  }
  EXPECT_GT(most, 60U);
  EXPECT_LT(most, 400U);
}

}  // namespace
}  // namespace ariadne::experiments
