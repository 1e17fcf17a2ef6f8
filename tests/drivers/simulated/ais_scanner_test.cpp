#include "drivers/simulated/ais_scanner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/geometry/angles.h"
#include "slam/geometry/so3.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {
namespace {

using slam::LaserSweep;
using slam::Pose3;
using slam::RadFromDeg;
using slam::Scan;

AisScannerOptions Exact(int slices = 256) {
  AisScannerOptions options;
  options.slices = slices;
  options.range_finder = WithoutErrors(options.range_finder);
  return options;
}

Scan TakeExact(const World& world, const Pose3& T_map_base, const AisScannerOptions& options,
               double start_time = 0.0) {
  return TakeAisScan(RayScene(world), T_map_base, start_time, options, 1, 0, Parallel(2));
}

Pose3 AtX(double x) { return {Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}}; }

/// How far a point is from the nearest of a box's six planes [m].
double DistanceToPlanes(const slam::Box3& box, const Eigen::Vector3d& p) {
  return std::min((p - box.min()).cwiseAbs().minCoeff(), (box.max() - p).cwiseAbs().minCoeff());
}

TEST(AisScan, PutsPointsOntoPlanes) {
  const slam::Box3 room(Eigen::Vector3d(-13.0, -9.0, 0.0), Eigen::Vector3d(41.0, 15.0, 5.0));
  const Pose3 T_map_base{slam::ExpSo3({0.02, -0.03, 0.5}), {0.3, -0.2, 0.1}};
  for (const SlicePoints points : {SlicePoints::k181, SlicePoints::k361, SlicePoints::k721}) {
    AisScannerOptions options = Exact(64);
    options.points = points;
    const Scan scan = TakeExact(EmptyRoom(room.min(), room.max()), T_map_base, options, 12.5);
    const slam::PointCloud cloud = slam::ToPointCloud(scan);
    EXPECT_EQ(cloud.size(), AisMounting(options).beams * 64);
    for (const Eigen::Vector3d& p_laser : cloud.positions) {
      const Eigen::Vector3d p_map = T_map_base * (AisMounting(options).T_base_laser * p_laser);
      EXPECT_LT(DistanceToPlanes(room, p_map), p_laser.norm() <= 10.0 ? 1e-4 : 1e-3) << p_map.transpose();
    }
  }
}

TEST(AisScan, HasThePointsAndTheTimesOfThePaper) {
  const Scan scan = TakeExact(EmptyRoom({-3, -3, 0}, {3, 3, 3}), {}, Exact());
  EXPECT_EQ(scan.sweeps.size(), 256u);
  EXPECT_EQ(slam::ToPointCloud(scan).size(), 46'336u);
  EXPECT_NEAR(AisScanDuration(Exact()), 3.4, 0.02);
  AisScannerOptions options = Exact(128);
  EXPECT_NEAR(AisSliceDuration(options), 0.01333, 1e-5);
  options.points = SlicePoints::k361;
  EXPECT_NEAR(AisSliceDuration(options), 0.02667, 1e-5);
  EXPECT_EQ(AisMounting(options).beams, 361u);
  options.points = SlicePoints::k721;
  EXPECT_NEAR(AisSliceDuration(options), 0.05333, 1e-5);
  EXPECT_EQ(AisMounting(options).beams, 721u);
}

TEST(AisScan, TiltsEvenlyUpwardsWithoutAStop) {
  const AisScannerOptions options = Exact(128);
  const Scan scan = TakeExact(EmptyRoom({-3, -3, 0}, {3, 3, 3}), {}, options, 100.0);
  EXPECT_DOUBLE_EQ(scan.sweeps.front().pitch, options.lowest_pitch);
  for (std::size_t s = 0; s < scan.sweeps.size(); ++s) {
    const LaserSweep& slice = scan.sweeps[s];
    const double end = slice.pitch + slice.pitch_rate * AisSliceDuration(options);
    const double next = s + 1 < scan.sweeps.size() ? scan.sweeps[s + 1].pitch : options.highest_pitch;
    EXPECT_NEAR(end, next, 1e-12);
    EXPECT_NEAR(slice.stamp, 100.0 + static_cast<double>(s) / 75.0, 1e-9);
  }
  EXPECT_NEAR(options.highest_pitch - options.lowest_pitch, RadFromDeg(120.0), 1e-12);
}

TEST(AisScan, SweepsFromRightToLeft) {
  const AisScannerOptions options = Exact(1);
  const auto beams = SweepBeams(AisMounting(options), Standing({}), 0.0, 0.0, 0.0);
  EXPECT_LT((beams.front().direction_map - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((beams[90].direction_map - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((beams.back().direction_map - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12);
  EXPECT_NEAR(beams.back().time, 0.5 / 75.0, 1e-12) << "half a turn of the mirror";
}

TEST(AisScan, GivesEachBeamThePitchOfItsTime) {
  const double rate = RadFromDeg(35.0);
  const auto beams = SweepBeams(AisMounting(Exact()), Standing({}), 2.0, RadFromDeg(10.0), rate);
  for (const Ray& beam : beams) {
    if (std::abs(beam.direction_map.y()) > 0.99) continue;  // nearly along the tilt axis
    const double pitch = std::atan2(beam.direction_map.z(), beam.direction_map.x());
    EXPECT_NEAR(pitch, RadFromDeg(10.0) + rate * (beam.time - 2.0), 1e-12);
  }
}

TEST(AisScan, SeesAMovingBodyWhereItIsAtThatTime) {
  World world = EmptyRoom({-20, -20, 0}, {20, 20, 20});
  Body door = BoxBody("door", {0.0, -10.0, 0.0}, {0.1, 10.0, 20.0});
  door.motion = {{5.0, 9.0}, {AtX(3.0), AtX(7.0)}};
  world.bodies.push_back(door);
  const AisScannerOptions options = Exact();
  const Scan scan = TakeExact(world, {}, options, 5.0);
  std::size_t seen = 0;
  for (const LaserSweep& slice : scan.sweeps) {
    const double after_stamp = slam::BeamTime(scan.scanner, 90);
    const double pitch = slice.pitch + slice.pitch_rate * after_stamp;
    if (std::abs(pitch) > RadFromDeg(5.0)) continue;
    const double x = 3.0 + (slice.stamp + after_stamp - 5.0);  // 1 m/s away from the robot
    EXPECT_NEAR(slice.ranges[90] * std::cos(pitch), x - options.mount_x, 1e-4);
    ++seen;
  }
  EXPECT_GT(seen, 15u);
}

TEST(AisScan, CastsFromTheMirrorThatIsOffTheTiltAxis) {
  AisScannerOptions options = Exact(1);
  options.lowest_pitch = RadFromDeg(30.0);
  options.mirror_forward = 0.08;
  options.mirror_up = 0.05;
  const Ray ahead = SweepBeams(AisMounting(options), Standing({}), 0.0, RadFromDeg(30.0), 0.0)[90];
  const Eigen::Vector3d mirror_laser(0.08 * std::sqrt(0.75) - 0.05 * 0.5, 0.0,
                                     0.08 * 0.5 + 0.05 * std::sqrt(0.75));
  EXPECT_LT((ahead.origin_map - AisMounting(options).T_base_laser * mirror_laser).norm(), 1e-12);
}

TEST(AisSweep, IsHorizontal) {
  const World world = EmptyRoom({-3, -4, 0}, {5, 4, 3});
  const AisScannerOptions options = Exact();
  const LaserSweep sweep = TakeAisSweep(RayScene(world), Standing({}), 7.0, options, 1, 0);
  EXPECT_EQ(sweep.stamp, 7.0);
  EXPECT_EQ(sweep.pitch, 0.0);
  EXPECT_EQ(sweep.pitch_rate, 0.0);
  ASSERT_EQ(sweep.ranges.size(), 181u);
  EXPECT_NEAR(sweep.ranges[0], 4.0, 1e-6);
  EXPECT_NEAR(sweep.ranges[90], 5.0 - options.mount_x, 1e-6);
  EXPECT_NEAR(sweep.ranges[180], 4.0, 1e-6);
}

TEST(AisSweep, SeesTheRobotDriveOn) {
  const World world = EmptyRoom({-3, -4, 0}, {5, 4, 3});
  Motion way = Standing({});
  way.times = {0.0, 1.0};
  way.T_map_body.push_back(way.T_map_body[0]);
  way.T_map_body[1].translation.y() = 0.8;  // to the left, faster than Ariadne ever drives sideways
  const LaserSweep sweep = TakeAisSweep(RayScene(world), way, 0.5, Exact(), 1, 0);
  EXPECT_NEAR(sweep.ranges[0], 4.4, 1e-6) << "to the right, at the stamp";
  EXPECT_NEAR(sweep.ranges[180], 3.6 - 0.8 * 0.5 / 75.0, 1e-6) << "to the left, half a turn later";
}

}  // namespace
}  // namespace ariadne::drivers
