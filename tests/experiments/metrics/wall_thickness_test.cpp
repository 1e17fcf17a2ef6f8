#include "experiments/metrics/wall_thickness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "slam/base/error.h"
#include "slam/base/random.h"
#include "slam/geometry/so3.h"
#include "tests/experiments/metrics/box_bodies.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

WallFaceOptions WithFloors() {
  WallFaceOptions options;
  options.max_tilt = std::numbers::pi / 2.0;
  return options;
}

TEST(FindWallFaces, MakesOneFaceOfEachSide) {
  const WallFaces walls = FindWallFaces(Room(), WithFloors());
  ASSERT_EQ(walls.faces.size(), 6u);
  double area = 0.0;
  for (const WallFace& face : walls.faces) area += face.area;
  EXPECT_NEAR(area, 2 * (4 * 6 + 4 * 2.5 + 6 * 2.5), 1e-12);
  for (std::size_t t = 0; t < 12; t += 2) EXPECT_EQ(walls.face_of[0][t], walls.face_of[0][t + 1]);
  EXPECT_EQ(FindWallFaces(Room(), {}).faces.size(), 4u) << "without floor and ceiling";
}

TEST(FindWallFaces, LeavesOutSmallAndMovingThings) {
  drivers::World world = Room();
  world.bodies.push_back(Box("box", {1, 1, 0}, {1.5, 1.5, 0.9}));  // sides of 0.45 m^2
  world.bodies.push_back(Walker());
  const WallFaces walls = FindWallFaces(world, {});
  EXPECT_EQ(walls.faces.size(), 4u);
  ASSERT_EQ(walls.face_of.size(), 3u);
  EXPECT_EQ(walls.face_of[1], std::vector<std::uint32_t>(12, kNoWall));
  EXPECT_EQ(walls.face_of[2], std::vector<std::uint32_t>(12, kNoWall));
}

/// A wall of strips, each of them turned against the one before it, with corners of its own.
drivers::World Strips(double angle) {
  drivers::World world{"strips", {{"strips", {}, {}, {}}}, {}};
  drivers::TriangleMesh& mesh = world.bodies[0].mesh_body;
  Vector3d at = Vector3d::Zero();
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Vector3d next = at + Vector3d(std::cos(i * angle), std::sin(i * angle), 0.0);
    for (const Vector3d& p : {at, next}) {
      mesh.vertices.push_back(p);
      mesh.vertices.push_back(p + 2.0 * Vector3d::UnitZ());
    }
    mesh.triangles.push_back({4 * i, 4 * i + 2, 4 * i + 3});
    mesh.triangles.push_back(
        {4 * i, 4 * i + 1, 4 * i + 3});  // seen from the other side: normals differ in sign
    at = next;
  }
  return world;
}

TEST(FindWallFaces, WeldsRepeatedCorners) {
  const WallFaces walls = FindWallFaces(Strips(0.0), {});
  ASSERT_EQ(walls.faces.size(), 1u);
  EXPECT_NEAR(walls.faces[0].area, 20.0, 1e-12);
}

TEST(FindWallFaces, DoesNotCreepAroundACurve) {
  EXPECT_EQ(FindWallFaces(Strips(0.02), {}).faces.size(), 10u);
  const WallFaces gentle =
      FindWallFaces(Strips(0.001), {});  // 2 mm from the first strip's plane after a few
  EXPECT_GT(gentle.faces.size(), 1u);
  EXPECT_LT(gentle.faces.size(), 10u);
}

TEST(AssignToWalls, TakesTheNearestSurfaceWithinTheGate) {
  const drivers::World world = TwoRooms(1.0);
  const WallFaces walls = FindWallFaces(world, {});
  const std::vector<std::uint32_t> assigned =
      AssignToWalls({{0.05, 1, 1}, {0.5, 1, 1}, {2, 2.95, 1}, {2, 3.25, 1}, {2, 3.09, 1}, {2, 1.5, 0.01}},
                    walls, drivers::SurfaceDistance(world), 0.15, Parallel(1));
  const auto plane = [&](std::size_t k) { return walls.faces[assigned[k]].plane_world; };
  ASSERT_NE(assigned[0], kNoWall);
  EXPECT_NEAR(plane(0).Distance({0, 5, 2}), 0.0, 1e-12) << "x = 0";
  EXPECT_EQ(assigned[1], kNoWall) << "beyond the gate";
  EXPECT_NEAR(plane(2).Distance({1, 3, 2}), 0.0, 1e-12) << "y = 3";
  EXPECT_NEAR(plane(3).Distance({1, 3.2, 2}), 0.0, 1e-12) << "y = 3.2";
  EXPECT_EQ(assigned[4], assigned[2]) << "inside of the wall: the nearer side";
  EXPECT_EQ(assigned[5], kNoWall) << "the floor is no wall";
}

/// Points on the wall y = 3 of TwoRooms, as a scan has them.
std::vector<Vector3d> PointsOnWall(int count, RandomStream& stream) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(DrawUniform(stream, 0.3, 2.7), 3.0, DrawUniform(stream, 0.3, 2.2));
  return points;
}

struct WallInTwoRooms {
  drivers::World world = TwoRooms(1.0);
  WallFaces walls = FindWallFaces(world, {});
  drivers::SurfaceDistance surface{world};
  RandomStream stream = NamedStream(1, "wall_thickness_test");
};

TEST(MeasureWallThickness, IsTheSigmaOfTheNoise) {
  WallInTwoRooms s;
  std::vector<Vector3d> points = PointsOnWall(20000, s.stream);
  for (Vector3d& p : points) p.y() += DrawNormal(s.stream, 0.0, 0.01);
  const auto assigned = AssignToWalls(points, s.walls, s.surface, 0.1, Parallel(2));
  const WallThicknessSummary summary = MeasureWallThickness(points, assigned, s.walls, {});
  ASSERT_EQ(summary.walls.size(), 1u);
  EXPECT_EQ(summary.walls[0].points, 20000u);
  EXPECT_NEAR(summary.median_standard_deviation, 0.01, 2e-4);
  EXPECT_NEAR(summary.worst_spread, 0.0329, 1e-3);
  EXPECT_NEAR(summary.walls[0].shift, 0.0, 3e-4);
}

TEST(MeasureWallThickness, SeesAWallThatStandsTwiceHoweverFarApart) {
  // Two scans of one wall, the second half a metre off in the map: assigned by the truth, nothing is lost.
  WallInTwoRooms s;
  const std::vector<Vector3d> truth = PointsOnWall(2000, s.stream);
  std::vector<Vector3d> map = truth;
  for (std::size_t k = 1000; k < 2000; ++k) map[k].y() -= 0.5;
  const auto by_truth = AssignToWalls(truth, s.walls, s.surface, 0.05, Parallel(1));
  const WallThicknessSummary summary = MeasureWallThickness(map, by_truth, s.walls, {});
  ASSERT_EQ(summary.walls.size(), 1u);
  EXPECT_NEAR(summary.worst_standard_deviation, 0.25, 1e-12);
  EXPECT_NEAR(summary.worst_spread, 0.5, 1e-12);
  EXPECT_NEAR(std::abs(summary.walls[0].shift), 0.25, 1e-12);
  const auto by_map = AssignToWalls(map, s.walls, s.surface, 0.15, Parallel(1));
  EXPECT_NEAR(MeasureWallThickness(map, by_map, s.walls, {}).worst_spread, 0.0, 1e-12)
      << "a gate in the map hides the second wall: that is why the truth assigns";
}

TEST(MeasureWallThickness, FindsAWallThinThatIsOnlyShifted) {
  WallInTwoRooms s;
  std::vector<Vector3d> points = PointsOnWall(500, s.stream);
  const auto assigned = AssignToWalls(points, s.walls, s.surface, 0.05, Parallel(1));
  for (Vector3d& p : points) p.y() += 0.3;
  const WallThicknessSummary summary = MeasureWallThickness(points, assigned, s.walls, {});
  EXPECT_NEAR(summary.worst_standard_deviation, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(summary.walls[0].shift), 0.3, 1e-12);
}

TEST(MeasureWallThickness, TakesMedianAndWorstOverWallsWithEnoughPoints) {
  WallFaces walls;
  std::vector<Vector3d> points;
  std::vector<std::uint32_t> assigned;
  for (std::uint32_t face = 0; face < 4; ++face) {  // thicknesses 1, 2, 4 cm; and 9 cm with too few points
    walls.faces.push_back({{Vector3d::UnitX(), 5.0}, 1.0});
    const double half = face == 3 ? 0.09 : 0.01 * (1 << face);
    for (int k = 0; k < (face == 3 ? 98 : 100); ++k) {
      points.emplace_back(5.0 + (k % 2 == 0 ? half : -half), 0, 0);
      assigned.push_back(face);
    }
  }
  const WallThicknessSummary summary = MeasureWallThickness(points, assigned, walls, {});
  ASSERT_EQ(summary.walls.size(), 3u);
  EXPECT_NEAR(summary.median_standard_deviation, 0.02, 1e-12);
  EXPECT_NEAR(summary.worst_standard_deviation, 0.04, 1e-12);
  EXPECT_NEAR(summary.median_spread, 0.04, 1e-12);
  EXPECT_NEAR(summary.worst_spread, 0.08, 1e-12);
}

TEST(MeasureWallThickness, IsNothingWithoutWalls) {
  EXPECT_TRUE(MeasureWallThickness({{1, 2, 3}}, {kNoWall}, {}, {}).walls.empty());
  EXPECT_THROW(MeasureWallThickness({{1, 2, 3}}, {}, {}, {}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
