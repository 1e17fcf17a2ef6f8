#include "drivers/simulated/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/simulated/closest_point.h"
#include "tests/support/random_geometry.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;

const Triangle kTriangle{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};

TEST(ClosestPoint, IsTheFootInsideAndOnTheBorderOutside) {
  EXPECT_EQ(ClosestPoint(kTriangle, {1, 1, 5}), Vector3d(1, 1, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {1, 1, -5}), Vector3d(1, 1, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {2, -3, 1}), Vector3d(2, 0, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {-1, 2, 1}), Vector3d(0, 2, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {6, -1, 1}), Vector3d(4, 0, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {-1, 7, 0}), Vector3d(0, 3, 0));
  EXPECT_EQ(ClosestPoint(kTriangle, {-1, -1, 0}), Vector3d(0, 0, 0));
  EXPECT_NEAR(
      (ClosestPoint(kTriangle, Vector3d(2, 1.5, 0) + Vector3d(3, 4, 2)) - Vector3d(2, 1.5, 0)).norm(), 0.0,
      1e-12)
      << "the hypotenuse, along its normal (3, 4)";
}

TEST(ClosestPoint, OfATriangleWithoutAreaIsOnWhatItSpans) {
  EXPECT_EQ(ClosestPoint({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {2, 5, 0}), Vector3d(2, 0, 0));
  EXPECT_EQ(ClosestPoint({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {2, 5, 0}), Vector3d(1, 1, 1));
}

/// Triangles strewn about a place, in bodies with poses of their own.
World RandomWorld(const Vector3d& place, RandomStream& stream) {
  World world;
  for (int b = 0; b < 5; ++b) {
    Body body{
        "soup", {}, {}, {{0.0}, {slam::Pose3{{1, 0, 0, 0}, place} * slam::DrawMotion(stream, 2.0, 3.0)}}};
    for (std::uint32_t t = 0; t < 40; ++t) {
      const Vector3d corner = slam::DrawInCube(stream, 5.0);
      for (int k = 0; k < 3; ++k) body.mesh_body.vertices.push_back(corner + slam::DrawInCube(stream, 1.0));
      body.mesh_body.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    world.bodies.push_back(body);
  }
  return world;
}

double BruteForce(const World& world, const Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Body& body : world.bodies) {
    const TriangleMesh mesh = MeshAt(body, 0.0);
    for (const auto& [i, j, k] : mesh.triangles) {
      const Triangle triangle{mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
      nearest = std::min(nearest, (ClosestPoint(triangle, p) - p).norm());
    }
  }
  return nearest;
}

TEST(SurfaceDistance, IsThatOfTheNearestOfAllTriangles) {
  RandomStream stream = NamedStream(1, "surface_distance_test");
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(5000, -3000, 10)}) {
    const World world = RandomWorld(place, stream);
    const SurfaceDistance surface(world);
    for (int repeat = 0; repeat < 500; ++repeat) {
      const Vector3d p = place + slam::DrawInCube(stream, repeat % 2 == 0 ? 6.0 : 30.0);
      const ClosestSurface closest = surface.Closest(p);
      EXPECT_EQ(closest.distance, BruteForce(world, p));
      EXPECT_NEAR((closest.point_map - p).norm(), closest.distance, 1e-12);
    }
  }
}

TEST(SurfaceDistance, IsZeroOnTheSurface) {
  RandomStream stream = NamedStream(2, "surface_distance_test");
  const World world = RandomWorld(Vector3d::Zero(), stream);
  const SurfaceDistance surface(world);
  for (std::uint32_t b = 0; b < 5; ++b) {
    const TriangleMesh mesh = MeshAt(world.bodies[b], 0.0);
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vector3d p = (mesh.vertices[i] + mesh.vertices[j] + mesh.vertices[k]) / 3.0;
      EXPECT_LT(surface.Closest(p).distance, 1e-14);
    }
  }
}

TEST(SurfaceDistance, NamesBodyAndTriangle) {
  World world;
  world.bodies.push_back({"far", {{{9, 0, 0}, {9, 1, 0}, {9, 0, 1}}, {{0, 1, 2}}}, {}, {}});
  world.bodies.push_back(
      {"near",
       {{{7, 0, 0}, {7, 1, 0}, {7, 0, 1}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {{0, 1, 2}, {3, 4, 5}}},
       {},
       {}});
  const ClosestSurface closest = SurfaceDistance(world).Closest({1, 0.1, 0.1});
  EXPECT_EQ(closest.body, 1u);
  EXPECT_EQ(closest.triangle, 1u);
  EXPECT_EQ(closest.distance, 1.0);
  EXPECT_EQ(closest.point_map, Vector3d(2, 0.1, 0.1));
}

TEST(SurfaceDistance, LooksNoFartherThanAsked) {
  World world;
  world.bodies.push_back({"plate", {{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {{0, 1, 2}}}, {}, {}});
  const SurfaceDistance surface(world);
  EXPECT_FALSE(surface.Closest({1, 0.1, 0.1}, 0.999).found());
  EXPECT_TRUE(surface.Closest({1, 0.1, 0.1}, 1.001).found());
  EXPECT_EQ(surface.Closest({1, 0.1, 0.1}, 0.999).distance, std::numeric_limits<double>::infinity());
}

TEST(SurfaceDistance, LeavesOutWhatMoves) {
  World world;
  Body walker{"walker", {{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {{0, 1, 2}}}, {}, {}};
  walker.motion = {{0.0, 1.0}, {slam::Pose3(), slam::Pose3{{1, 0, 0, 0}, {5, 0, 0}}}};
  world.bodies.push_back(walker);
  EXPECT_FALSE(SurfaceDistance(world).Closest({2, 0, 0}).found());
  EXPECT_FALSE(SurfaceDistance(World()).Closest({2, 0, 0}).found());
}

}  // namespace
}  // namespace ariadne::drivers
