#include "experiments/metrics/map_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/random.h"
#include "slam/geometry/so3.h"
#include "tests/experiments/metrics/box_bodies.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

TEST(MeasureMapError, HasTheStatisticsOfTheDistances) {
  // Before the wall x = 0, far from all others: 0, 1, 2, 3 and 10 cm.
  const std::vector<Vector3d> points{{0, 3, 1}, {0.02, 3, 1}, {0.03, 3, 1}, {0.01, 3, 1}, {-0.10, 3, 1}};
  const MapError e = MeasureMapError(points, {}, drivers::SurfaceDistance(Room()), {}, Parallel(1));
  EXPECT_EQ(e.points, 5u);
  EXPECT_NEAR(e.mean, 0.032, 1e-15);
  EXPECT_NEAR(e.median, 0.02, 1e-15);
  EXPECT_NEAR(e.rms, std::sqrt(0.0114 / 5.0), 1e-15);
  EXPECT_NEAR(e.percentile_95, 0.086, 1e-15) << "0.8 of the way from 3 to 10 cm";
  EXPECT_NEAR(e.max, 0.10, 1e-15);
  EXPECT_DOUBLE_EQ(e.share_within, 0.6);
}

TEST(MeasureMapError, PlacesTheMapByItsMaster) {
  // A map in which the master scan is not at the origin, of a world in which it is elsewhere again.
  const slam::Pose3 T_map_master{slam::ExpSo3({0, 0, 0.7}), {5, 6, 7}};
  const slam::Pose3 T_world_master{slam::ExpSo3({0.1, 0, -0.4}), {1, 1, 1}};
  const slam::Pose3 T_world_map = PlaceByMaster(T_map_master, T_world_master);
  std::vector<Vector3d> points_map;
  for (double z = 0.2; z < 2.4; z += 0.1) points_map.push_back(T_world_map.Inverse() * Vector3d(4, 2, z));
  const MapError e =
      MeasureMapError(points_map, T_world_map, drivers::SurfaceDistance(Room()), {}, Parallel(1));
  EXPECT_LT(e.max, 1e-14);
  EXPECT_EQ(e.share_within, 1.0);
}

TEST(MeasureMapError, CountsPointsOnAPersonWhoWalks) {
  drivers::World world = Room();
  world.bodies.push_back(Walker());
  const MapError e =
      MeasureMapError({{1.0, 1.8, 1.2}}, {}, drivers::SurfaceDistance(world), {}, Parallel(1));
  EXPECT_NEAR(e.max, 1.0, 1e-15) << "to the wall";
}

TEST(MeasureMapError, DoesNotDependOnTheThreads) {
  RandomStream stream = NamedStream(1, "map_error_test");
  std::vector<Vector3d> points;
  for (int i = 0; i < 20000; ++i)
    points.emplace_back(DrawNormal(stream, 0, 0.01), DrawUniform(stream, 1, 5), DrawUniform(stream, 1, 2));
  const drivers::SurfaceDistance surface(Room());
  const MapError one = MeasureMapError(points, {}, surface, {}, Parallel(1));
  const MapError two = MeasureMapError(points, {}, surface, {}, Parallel(2));
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.percentile_95, two.percentile_95);
  EXPECT_NEAR(one.mean, 0.01 * std::sqrt(2.0 / std::numbers::pi), 2e-4) << "of a half normal distribution";
}

TEST(MeasureMapError, OfNothingIsNothing) {
  EXPECT_EQ(MeasureMapError({}, {}, drivers::SurfaceDistance(Room()), {}, Parallel(1)).points, 0u);
}

}  // namespace
}  // namespace ariadne::experiments
