// The driver of the whole robot on emulated devices in one simulated world, in virtual time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/simulated/surface_distance.h"
#include "tests/drivers/emulated/robot/robot_bench.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

World Room() { return FurnishedRoom(); }

TEST(HardwareRobot, ScansWhatIsThere) {
  RobotBench bench(Room());
  bench.robot->Connect();
  const slam::Scan scan = bench.robot->TakeScan();
  EXPECT_NEAR(static_cast<double>(scan.sweeps.size()), 128.0, 3.0);
  const SurfaceDistance surface(Room());
  std::vector<double> errors;
  for (const Eigen::Vector3d& p_laser : slam::ToPointCloud(scan).positions)
    errors.push_back(surface.Closest(bench.robot->T_base_laser() * p_laser).distance);
  ASSERT_GT(errors.size(), 120U * 170U);
  std::sort(errors.begin(), errors.end());
  fmt::print("median {} 95% {} max {}\n", errors[errors.size() / 2], errors[errors.size() * 95 / 100],
             errors.back());
  EXPECT_LT(errors[errors.size() / 2], 0.004);  // centimetres, and steps of the servo
  EXPECT_LT(errors.back(), 0.05);
}

TEST(HardwareRobot, KnowsWhereItHasDriven) {
  RobotBench bench(Room());
  bench.robot->Connect();
  for (int side = 0; side < 4; ++side) {
    bench.DriveFor({0.4, 0.0}, 2.0);
    bench.Halt();
    bench.DriveFor({0.0, 0.5}, M_PI);
    bench.Halt();
  }
  const slam::Pose2 odometry = bench.robot->State().odometry.T_odom_base;
  const slam::Pose2 truth = bench.device.base().T_map_base_true();
  fmt::print("{} {} {} vs {} {} {}\n", odometry.translation.x(), odometry.translation.y(), odometry.angle,
             truth.translation.x(), truth.translation.y(), truth.angle);
  EXPECT_LT((odometry.translation - truth.translation).norm(), 0.01);
  EXPECT_NEAR(slam::WrapAngle(odometry.angle - truth.angle), 0.0, 0.01);
}

}  // namespace
}  // namespace ariadne::drivers
namespace ariadne::drivers {
TEST(Tmp, Pitch) {
  RobotBench bench(FurnishedRoom());
  bench.robot->Connect();
  const slam::Scan scan = bench.robot->TakeScan();
  double offset = scan.sweeps.front().stamp;
  (void)offset;
  double sum = 0, sq = 0, n = 0, mx = 0;
  for (const auto& s : scan.sweeps) {
    const double truth = 2 * M_PI * (bench.device.servo().PositionAt(s.stamp) - 0.5);
    const double e = s.pitch - truth;
    sum += e; sq += e * e; n += 1; mx = std::max(mx, std::abs(e));
    if (int(n) % 16 == 0) fmt::print("{} stamp {} pitch {} e {} rate {}\n", n, s.stamp, s.pitch, e, s.pitch_rate);
  }
  fmt::print("mean {} rms {} max {}\n", sum / n, std::sqrt(sq / n), mx);
}
}  // namespace ariadne::drivers
