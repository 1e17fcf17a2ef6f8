#include "experiments/mission/ground_map.h"

#include <gtest/gtest.h>

#include <numbers>

#include "experiments/mission/mission_options.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// What rows of beams from 0.9 m above the floor meet within 6 m: the floor, and a table from x = 2 m on
/// whose top is 0.72 m high. Beams that would meet it beyond x = `seen` are missing, as where rows are
/// sparse.
slam::PosedCloud ScanOfTable(double seen) {
  constexpr double kLaser = 0.9, kTop = 0.72, kFront = 2.0, kBack = 2.8, kSide = 0.6;
  slam::PosedCloud scan;
  scan.name = "table";
  scan.T_map_laser.translation.z() = kLaser;
  for (double bearing = -0.9; bearing <= 0.9; bearing += 0.008) {
    for (double depression = -0.4; depression < 1.3; depression += 0.006) {
      const Vector3d beam(std::cos(bearing) * std::cos(depression),
                          std::sin(bearing) * std::cos(depression), -std::sin(depression));
      const double to_floor = beam.z() < 0.0 ? kLaser / -beam.z() : 6.0;
      const double to_top = beam.z() < 0.0 ? (kLaser - kTop) / -beam.z() : 6.0;
      const double to_front = kFront / beam.x();
      const auto meets = [&](double range) {
        const Vector3d p = range * beam;
        return p.x() >= kFront - 1e-9 && p.x() < kBack && std::abs(p.y()) < kSide && range < to_floor;
      };
      if (meets(to_front) && to_top < to_front) {  // its front, under the top, which is closed
        scan.cloud_laser.positions.push_back(to_front * beam);
      } else if (meets(to_top)) {
        if ((to_top * beam).x() < seen) scan.cloud_laser.positions.push_back(to_top * beam);
      } else {
        scan.cloud_laser.positions.push_back(std::min(to_floor, 6.0) * beam);
      }
    }
  }
  return scan;
}

Ground LookAt(const slam::PosedCloud& scan, const ClearOptions& clear) {
  GroundMap map(RobotObstacleOptions(), clear, {});
  const std::array<std::size_t, 1> shown{0};
  const slam::Pose2 stand;
  return map.Look({&scan, 1}, shown, {&scan.T_map_laser, 1}, {&stand, 1});
}

double Nearest(const std::vector<Vector2d>& places, const Vector2d& p_map) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector2d& place : places) nearest = std::min(nearest, (place - p_map).norm());
  return nearest;
}

TEST(GroundMap, TakesWhatNoBeamShowsForUnclear) {
  const Ground ground = LookAt(ScanOfTable(2.3), {});
  EXPECT_LT(Nearest(ground.obstacles_map, {2.02, 0.0}), 0.05);
  EXPECT_GT(Nearest(ground.obstacles_map, {2.75, 0.5}), 0.2) << "nothing is met there";
  EXPECT_LT(Nearest(ground.unclear_map, {2.75, 0.58}), 0.15) << "but nothing shows that it is clear";
  EXPECT_GT(Nearest(ground.unclear_map, {1.5, 0.0}), 0.3);
  EXPECT_GT(Nearest(ground.unclear_map, {1.7, 1.0}), 0.3);
}

TEST(GroundMap, LooksForNothingUnclearWithoutGaps) {
  EXPECT_TRUE(LookAt(ScanOfTable(2.3), {.gap = 0.0}).unclear_map.empty());
}

TEST(GroundMap, MovesWithItsScans) {
  slam::PosedCloud scan = ScanOfTable(2.3);
  const Ground ground = LookAt(scan, {});
  const Vector2d moved(3.0, -6.0);  // a whole number of cells
  scan.T_map_laser.translation.head<2>() += moved;
  GroundMap map(RobotObstacleOptions(), {}, {});
  const std::array<std::size_t, 1> shown{0};
  const slam::Pose2 stand{0.0, moved};
  const Ground there = map.Look({&scan, 1}, shown, {&scan.T_map_laser, 1}, {&stand, 1});
  ASSERT_FALSE(ground.unclear_map.empty());
  for (const Vector2d& p_map : ground.unclear_map)
    EXPECT_LT(Nearest(there.unclear_map, p_map + moved), 0.05);
  for (const Vector2d& p_map : ground.obstacles_map)
    EXPECT_LT(Nearest(there.obstacles_map, p_map + moved), 0.05);
}

TEST(GroundMap, KnowsWhatWasMetAndTheFence) {
  GroundMap map(RobotObstacleOptions(), {}, {{5.0, 5.0}});
  map.AddObstacle({-1.0, 2.0});
  const slam::PosedCloud scan = ScanOfTable(2.3);
  const std::array<std::size_t, 1> shown{0};
  const slam::Pose2 stand;
  const Ground ground = map.Look({&scan, 1}, shown, {&scan.T_map_laser, 1}, {&stand, 1});
  EXPECT_EQ(Nearest(ground.obstacles_map, {5.0, 5.0}), 0.0);
  EXPECT_EQ(Nearest(ground.obstacles_map, {-1.0, 2.0}), 0.0);
}

}  // namespace
}  // namespace ariadne::experiments
