#include "experiments/metrics/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/metrics/reachable.h"
#include "experiments/metrics/surface_samples.h"
#include "slam/base/error.h"
#include "slam/geometry/so3.h"
#include "tests/experiments/metrics/box_bodies.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

constexpr double kRoomArea = 2 * (4 * 6 + 4 * 2.5 + 6 * 2.5);

TEST(SampleSurface, IsSpreadByArea) {
  const SurfaceSamples samples = SampleSurface(Room(), 100.0, 1);
  EXPECT_NEAR(samples.area, kRoomArea, 1e-12);
  EXPECT_EQ(samples.points_world.size(), 9800u);
  const auto on = [&](auto&& condition) { return std::ranges::count_if(samples.points_world, condition); };
  EXPECT_NEAR(on([](const Vector3d& p) { return std::abs(p.z()) < 1e-12; }), 2400, 2);
  EXPECT_NEAR(on([](const Vector3d& p) { return std::abs(p.x()) < 1e-12; }), 1500, 2);
  EXPECT_NEAR(on([](const Vector3d& p) { return std::abs(p.z()) < 1e-12 && p.x() < 2 && p.y() < 3; }), 600,
              80)
      << "uniform in each triangle, about 4 sigma";
}

TEST(SampleSurface, DependsOnTheSeedAlone) {
  EXPECT_EQ(SampleSurface(Room(), 10.0, 1).points_world, SampleSurface(Room(), 10.0, 1).points_world);
  EXPECT_NE(SampleSurface(Room(), 10.0, 1).points_world, SampleSurface(Room(), 10.0, 2).points_world);
  EXPECT_TRUE(SampleSurface({}, 10.0, 1).points_world.empty());
  EXPECT_THROW(SampleSurface(Room(), 1e9, 1), Error);
}

double FarthestY(const drivers::World& world) {
  double farthest = 0.0;
  ReachableOptions options;
  options.step = 0.1;
  for (const Vector3d& p : ReachablePlaces(drivers::RayScene(world), options))
    farthest = std::max(farthest, p.y());
  return farthest;
}

TEST(ReachablePlaces, KeepAwayFromWalls) {
  const std::vector<Vector3d> places = ReachablePlaces(drivers::RayScene(Room()), {});
  for (const Vector3d& p : places) {
    EXPECT_GE(std::min({p.x(), 4.0 - p.x(), p.y(), 6.0 - p.y()}), 0.35 - 1e-9);
  }
  EXPECT_EQ(places.size(), 13u * 21u) << "x from 0.5 to 3.5, y from 0.5 to 5.5, every 0.25 m";
}

TEST(ReachablePlaces, GoThroughDoorsThatAreWideEnough) {
  EXPECT_NEAR(FarthestY(TwoRooms(1.0)), 5.6, 1e-9);
  EXPECT_LT(FarthestY(TwoRooms(0.6)), 3.0);
  EXPECT_LT(FarthestY(TwoRooms(0.0)), 3.0);
}

TEST(ReachablePlaces, GoNeitherUnderATableNorOntoAStep) {
  drivers::World table = TwoRooms(1.0);
  table.bodies.push_back(Box("table top", {2.5, 2.5, 0.7}, {4.0, 3.5, 0.75}));
  EXPECT_LT(FarthestY(table), 3.0);
  drivers::World step = TwoRooms(1.0);
  step.bodies.push_back(Box("step", {0, 3.0, 0}, {4.0, 6.0, 0.2}));
  EXPECT_LT(FarthestY(step), 3.0);
}

TEST(ReachablePlaces, DoNotSqueezeBetweenATableTopAndAJamb) {
  for (const double beside_table : {0.6, 0.8}) {  // free of the door, which is 1 m wide
    drivers::World world = TwoRooms(1.0);
    world.bodies.push_back(Box("table top", {3.0, 2.0, 0.70}, {4.0 - beside_table, 3.0, 0.73}));
    EXPECT_EQ(FarthestY(world) > 3.0, beside_table > 0.7) << beside_table;
  }
}

TEST(ReachablePlaces, NeedAFloorUnlessItIsNotAskedFor) {
  drivers::World walls{"walls", {}, {0.0, {1.0, 1.0}}};
  walls.bodies.push_back(Box("west", {-0.1, 0, 0}, {0, 6, 2.5}));
  walls.bodies.push_back(Box("east", {4, 0, 0}, {4.1, 6, 2.5}));
  walls.bodies.push_back(Box("south", {0, -0.1, 0}, {4, 0, 2.5}));
  walls.bodies.push_back(Box("north", {0, 6, 0}, {4, 6.1, 2.5}));
  const drivers::RayScene scene(walls);
  EXPECT_EQ(ReachablePlaces(scene, {}).size(), 1u) << "the start alone";
  ReachableOptions options;
  options.floor_tolerance = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ReachablePlaces(scene, options).size(), 13u * 21u);
}

TEST(ReachablePlaces, EndSomewhere) {
  drivers::World plain{"plain", {Box("floor", {-1000, -1000, -1}, {1000, 1000, 0})}, {}};
  ReachableOptions options;
  options.max_places = 1000;
  EXPECT_THROW(ReachablePlaces(drivers::RayScene(plain), options), Error);
}

TEST(ViewpointsAbove, IsOnePerSquare) {
  const auto viewpoints =
      ViewpointsAbove({{0.1, 0.1, 0}, {0.9, 0.9, 0}, {1.1, 0.1, 0}, {-0.1, 0.1, 0}}, 1.0, 1.2);
  ASSERT_EQ(viewpoints.size(), 3u);
  EXPECT_EQ(viewpoints[0], Vector3d(0.1, 0.1, 1.2));
}

VisibleSurface VisibleFrom(const drivers::World& world, const std::vector<Vector3d>& viewpoints,
                           int threads = 1) {
  VisibleSurfaceOptions options;
  options.lowest_elevation = -std::numbers::pi / 2;
  options.highest_elevation = std::numbers::pi / 2;
  return FindVisibleSurface(drivers::RayScene(world), viewpoints, options, Parallel(threads));
}

TEST(FindVisibleSurface, IsAllOfAnEmptyRoom) {
  const VisibleSurface surface = VisibleFrom(Room(), {{1, 1, 1}});
  EXPECT_NEAR(surface.area, kRoomArea, 1e-9);
  EXPECT_NEAR(surface.total_area, kRoomArea, 1e-9);
}

TEST(FindVisibleSurface, EndsAtAClosedWall) {
  const drivers::World world = TwoRooms(0.0);
  const VisibleSurface front = VisibleFrom(world, {{1, 1, 1}});
  for (const Vector3d& p : front.points_world) EXPECT_LE(p.y(), 3.0 + 1e-9);
  EXPECT_NEAR(front.area, 2 * (4 * 3 + 4 * 2.5 + 3 * 2.5), 1.0) << "the front room";
  const VisibleSurface both = VisibleFrom(world, {{1, 1, 1}, {1, 5, 1}}, 2);
  EXPECT_NEAR(both.area, front.area + 2 * (4 * 2.8 + 4 * 2.5 + 2.8 * 2.5), 1.5);
}

TEST(FindVisibleSurface, ThrowsShadows) {
  // A screen of 1 m^2 at 1 m from the viewpoint hides 4 m^2 of the wall at 2 m behind it.
  drivers::World world{"shadow", {}, {}};
  world.bodies.push_back(
      {"wall", {{{2, -4, -4}, {2, 4, -4}, {2, 4, 4}, {2, -4, 4}}, {{0, 1, 2}, {0, 2, 3}}}, {}, {}});
  world.bodies.push_back(
      {"screen",
       {{{1, -.5, -.5}, {1, .5, -.5}, {1, .5, .5}, {1, -.5, .5}}, {{0, 1, 2}, {0, 2, 3}}},
       {},
       {}});
  EXPECT_NEAR(VisibleFrom(world, {{0, 0, 0}}).area, 64.0 - 4.0 + 1.0, 0.5);
}

TEST(FindVisibleSurface, HasTheScannersRangeAndElevations) {
  VisibleSurfaceOptions options;
  options.max_range = 3.0;
  const Vector3d eye(2, 3, 1);
  const VisibleSurface surface = FindVisibleSurface(drivers::RayScene(Room()), {eye}, options, Parallel(1));
  EXPECT_FALSE(surface.points_world.empty());
  for (const Vector3d& p : surface.points_world) {
    EXPECT_LE((p - eye).norm(), 3.0);
    EXPECT_GE(std::atan2(p.z() - 1.0, (p - eye).head<2>().norm()), options.lowest_elevation);
    EXPECT_LE(std::atan2(p.z() - 1.0, (p - eye).head<2>().norm()), options.highest_elevation);
  }
}

TEST(FindVisibleSurface, DoesNotDependOnTheThreads) {
  const drivers::World world = TwoRooms(1.0);
  EXPECT_EQ(VisibleFrom(world, {{1, 1, 1}, {3.5, 2, 1}}, 1).points_world,
            VisibleFrom(world, {{1, 1, 1}, {3.5, 2, 1}}, 2).points_world);
}

TEST(MeasureCoverage, IsTheShareNearTheMap) {
  const VisibleSurface surface = VisibleFrom(Room(), {{1, 1, 1}});
  const slam::Pose3 T_world_map{slam::ExpSo3({0, 0, 1.0}), {3, -2, 0.5}};
  std::vector<Vector3d> floor_map;
  for (double x = 0.0; x < 4.01; x += 0.1) {
    for (double y = 0.0; y < 6.01; y += 0.1) floor_map.push_back(T_world_map.Inverse() * Vector3d(x, y, 0));
  }
  CoverageOptions options;
  options.radius = 0.08;
  const Coverage c = MeasureCoverage(floor_map, T_world_map, surface, options, Parallel(2));
  const double rim = 2 * (4 + 6) * 0.07;  // of the walls, near the floor
  EXPECT_NEAR(c.area, 24.0 + rim, 0.8);
  EXPECT_NEAR(c.share, c.area / kRoomArea, 1e-12);
  EXPECT_EQ(MeasureCoverage(floor_map, T_world_map, surface, options, Parallel(1)).covered, c.covered);
  EXPECT_EQ(MeasureCoverage(surface.points_world, {}, surface, {}, Parallel(1)).share, 1.0);
  EXPECT_EQ(MeasureCoverage({}, {}, surface, {}, Parallel(1)).share, 0.0);
  EXPECT_THROW(MeasureCoverage(floor_map, {}, {}, {}, Parallel(1)), Error);
}

}  // namespace
}  // namespace ariadne::experiments
