#include "drivers/simulated/ray_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// A rectangle at x = 0 of the body's frame, 2 x 2 m around the origin.
TriangleMesh Plate() { return {{{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}, {{0, 1, 2}, {0, 2, 3}}}; }

Motion StandingAt(const Vector3d& place) {
  return {{0.0}, {slam::Pose3{Eigen::Quaterniond::Identity(), place}}};
}

Body PlateAt(const Vector3d& place, double reflectance = 0.6) {
  return {"plate", Plate(), {reflectance}, StandingAt(place)};
}

Vector3d DrawDirection(RandomStream& stream) {
  return Vector3d(DrawNormal(stream, 0, 1), DrawNormal(stream, 0, 1), DrawNormal(stream, 0, 1))
      .normalized();
}

TEST(RayScene, HitsTheNearestOfTwo) {
  const RayScene scene({"two plates", {PlateAt({5, 0, 0}, 0.2), PlateAt({3, 0, 0}, 0.9)}, {}});
  const Hit hit = scene.Cast({Vector3d::Zero(), Vector3d::UnitX()});
  EXPECT_EQ(hit.body, 1u);
  EXPECT_EQ(hit.distance, 3.0);
  EXPECT_EQ(hit.reflectance, 0.9);
  EXPECT_EQ(hit.normal_map, Vector3d(-1, 0, 0));
  const Hit back = scene.Cast({Vector3d(9, 0.5, 0.2), -Vector3d::UnitX()});
  EXPECT_EQ(back.body, 0u);
  EXPECT_EQ(back.distance, 4.0);
  EXPECT_EQ(back.normal_map, Vector3d(1, 0, 0)) << "towards the ray's origin, from either side";
}

TEST(RayScene, MissesWhatIsBesideOrBehind) {
  const RayScene scene({"plate", {PlateAt({5, 0, 0})}, {}});
  EXPECT_FALSE(scene.Cast({Vector3d::Zero(), -Vector3d::UnitX()}).hit());
  EXPECT_FALSE(scene.Cast({Vector3d(0, 1.001, 0), Vector3d::UnitX()}).hit());
  EXPECT_TRUE(scene.Cast({Vector3d(0, 0.999, 0), Vector3d::UnitX()}).hit());
  EXPECT_EQ(scene.Cast({Vector3d::Zero(), Vector3d::UnitY()}).distance, Hit().distance);
}

TEST(RayScene, AnEmptyWorldIsEmpty) {
  const RayScene scene({"nothing", {}, {}});
  EXPECT_FALSE(scene.Cast({Vector3d::Zero(), Vector3d::UnitX()}).hit());
  EXPECT_FALSE(RayScene({"no triangles", {{"empty", {}, {}, {}}}, {}})
                   .Cast({Vector3d::Zero(), Vector3d::UnitX()})
                   .hit());
}

TEST(RayScene, HitsExactlyOnObliquePlanes) {
  // Every hit lies on its plane to double precision, up to 50 m away.
  RandomStream stream = NamedStream(7, "planes");
  for (int i = 0; i < 200; ++i) {
    const Vector3d normal = DrawDirection(stream);
    const double offset = DrawUniform(stream, 1.0, 30.0);
    Body wall{"wall", Plate(), {}, {}};
    const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), normal);
    for (Vector3d& v : wall.mesh_body.vertices) v = turn * (40.0 * v) + offset * normal;
    const RayScene scene({"wall", {wall}, {}});
    for (int k = 0; k < 20; ++k) {
      const Vector3d direction = DrawDirection(stream);
      const Hit hit = scene.Cast({Vector3d::Zero(), direction});
      if (!hit.hit()) continue;
      const double tolerance = 1e-13 * hit.distance / std::abs(normal.dot(direction));
      EXPECT_NEAR(hit.distance, offset / normal.dot(direction), tolerance);
      EXPECT_NEAR(hit.normal_map.dot(normal), -1.0, 1e-12);
    }
  }
}

TEST(RayScene, KeepsItsPrecisionFarFromTheOrigin) {
  const Vector3d far(4.5e6, -2.1e6, 300.0);  // as in projected map coordinates
  const RayScene scene(
      {"far", {PlateAt(far + Vector3d(2, 0, 0)), PlateAt(far + Vector3d(2.001, 0, 0))}, {}});
  for (double y = -0.95; y < 1.0; y += 0.1) {
    const Vector3d direction = Vector3d(2, y, 0.3 * y).normalized();
    const Hit hit = scene.Cast({far, direction});
    EXPECT_EQ(hit.body, 0u);
    EXPECT_NEAR(hit.distance * direction.x(), 2.0, 1e-8);
  }
}

TEST(RayScene, IsWatertightWhereTrianglesMeet) {
  // A fan of thin triangles around the middle of a plate: rays at the shared edges must not slip through.
  TriangleMesh fan{{{0, 0, 0}}, {}};
  constexpr int kCorners = 97;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    fan.vertices.push_back({0.0, std::cos(angle), std::sin(angle)});
    fan.triangles.push_back(
        {0, static_cast<unsigned>(i) + 1, static_cast<unsigned>((i + 1) % kCorners) + 1});
  }
  const RayScene scene({"fan", {{"fan", fan, {}, {}}}, {}});
  for (int i = 0; i < kCorners; ++i) {
    for (double s = 0.0; s < 0.99; s += 0.01) {
      const Vector3d target = s * fan.vertices[static_cast<std::size_t>(i) + 1];
      const Vector3d origin(-3.0, 0.3, -0.7);
      EXPECT_NEAR(scene.Cast({origin, (target - origin).normalized()}).distance, (target - origin).norm(),
                  1e-9);
    }
  }
}

TEST(RayScene, AGrazingHitStaysOnItsTriangle) {
  const RayScene scene({"plate", {PlateAt({0, 0, 0})}, {}});
  RandomStream stream = NamedStream(3, "graze");
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d target(0, DrawUniform(stream, -1, 1), DrawUniform(stream, -1, 1));
    const Vector3d origin(DrawUniform(stream, -1e-5, 1e-5), -4, target.z());
    const Hit hit = scene.Cast({origin, (target - origin).normalized()});
    if (!hit.hit()) continue;
    ++hits;
    EXPECT_GE(hit.distance, 3.0 - 1e-6);
    EXPECT_LE(hit.distance, 5.0 + 1e-6);
  }
  EXPECT_GT(hits, 10000);
}

/// A crowd of plates at random places, some of which move.
World Crowd() {
  World world{"crowd", {}, {}};
  RandomStream stream = NamedStream(11, "crowd");
  for (int i = 0; i < 60; ++i) {
    Body body = PlateAt(DrawUniform(stream, 2.0, 12.0) * DrawDirection(stream));
    body.motion.T_map_body[0].rotation =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), DrawDirection(stream));
    if (i % 3 == 0) {
      body.motion.times.push_back(2.0);
      body.motion.T_map_body.push_back(
          {Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), DrawDirection(stream)),
           6.0 * DrawDirection(stream)});
    }
    world.bodies.push_back(body);
  }
  return world;
}

/// The nearest hit by trying all triangles.
double NearestByBruteForce(const World& world, const Ray& ray) {
  double nearest = Hit().distance;
  for (const Body& body : world.bodies) {
    const slam::Pose3 T_map_body = PoseAt(body.motion, ray.time);
    for (const auto& t : body.mesh_body.triangles) {
      const Vector3d a = T_map_body * body.mesh_body.vertices[t[0]];
      Eigen::Matrix3d M;
      M << T_map_body * body.mesh_body.vertices[t[1]] - a, T_map_body * body.mesh_body.vertices[t[2]] - a,
          -ray.direction_map;
      const Vector3d uvt = M.inverse() * (ray.origin_map - a);
      if (uvt.x() >= 0 && uvt.y() >= 0 && uvt.x() + uvt.y() <= 1 && uvt.z() > 0)
        nearest = std::min(nearest, uvt.z());
    }
  }
  return nearest;
}

TEST(RayScene, AgreesWithBruteForceAtEveryTime) {
  const World world = Crowd();
  const RayScene scene(world);
  RandomStream stream = NamedStream(12, "rays");
  int different = 0, hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray{Vector3d::Zero(), DrawDirection(stream), DrawUniform(stream, -0.5, 2.5)};
    const Hit hit = scene.Cast(ray);
    const double expected = NearestByBruteForce(world, ray);
    hits += hit.hit();
    different += hit.hit() ? !(std::abs(hit.distance - expected) < 1e-9) : std::isfinite(expected);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LE(different, 1) << "only a ray within single precision of an edge may differ";
}

TEST(RayScene, ManyRaysHitWhatEachHitsAlone) {
  const RayScene scene(Crowd());
  RandomStream stream = NamedStream(13, "rays");
  std::vector<Ray> rays;
  for (int i = 0; i < 1003; ++i)
    rays.push_back({Vector3d(0.1, 0, 0), DrawDirection(stream), DrawUniform(stream, 0, 2)});
  std::vector<Hit> hits(rays.size());
  scene.Cast(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit alone = scene.Cast(rays[i]);
    EXPECT_EQ(hits[i].distance, alone.distance);
    EXPECT_EQ(hits[i].body, alone.body);
    EXPECT_EQ(hits[i].triangle, alone.triangle);
    EXPECT_EQ(hits[i].normal_map, alone.normal_map);
  }
}

TEST(RayScene, SeesAMovingBodyWhereItIsThen) {
  Body walker = PlateAt({2, 0, 0});
  walker.motion.times = {1.0, 3.0};
  walker.motion.T_map_body.push_back({Eigen::Quaterniond::Identity(), Vector3d(6, 0, 0)});
  const RayScene scene({"walker", {PlateAt({9, 0, 0}), walker}, {}});
  const auto distance = [&](double time) {
    return scene.Cast({Vector3d::Zero(), Vector3d::UnitX(), time}).distance;
  };
  EXPECT_EQ(distance(-5.0), 2.0) << "it stands before its first key frame";
  EXPECT_EQ(distance(2.0), 4.0);
  EXPECT_EQ(distance(2.5), 5.0);
  EXPECT_EQ(distance(99.0), 6.0);
  EXPECT_EQ(scene.Cast({Vector3d::Zero(), Vector3d::UnitX(), 2.0}).body, 1u);
}

TEST(RayScene, IgnoresTrianglesWithoutArea) {
  Body flat = PlateAt({3, 0, 0});
  flat.mesh_body.triangles = {{0, 0, 1}, {2, 2, 2}};
  const RayScene scene({"flat", {flat, PlateAt({5, 0, 0})}, {}});
  EXPECT_EQ(scene.Cast({Vector3d(0, 1, 1), Vector3d::UnitX()}).distance, 5.0);
}

TEST(RayScene, CanBeMoved) {
  RayScene first({"plate", {PlateAt({5, 0, 0})}, {}});
  const RayScene second = std::move(first);
  EXPECT_EQ(second.world().name, "plate");
  EXPECT_EQ(second.Cast({Vector3d::Zero(), Vector3d::UnitX()}).distance, 5.0);
}

std::string ErrorOfBody(const Body& body) {
  return ErrorOf([&] { RayScene({"damaged", {body}, {}}); });
}

TEST(RayScene, RefusesDamagedBodies) {
  Body body = PlateAt({0, 0, 0});
  body.mesh_body.triangles[1] = {0, 1, 4};
  EXPECT_THAT(ErrorOfBody(body), HasSubstr("plate: a triangle names vertex 4, but there are 4"));
  body = PlateAt({0, 0, 0});
  body.mesh_body.vertices[2].y() = std::nan("");
  EXPECT_THAT(ErrorOfBody(body), HasSubstr("plate: a vertex is not finite"));
  body = PlateAt({0, 0, 0});
  body.motion.times = {1.0, 1.0};
  EXPECT_THAT(ErrorOfBody(body), HasSubstr("2 times, but 1 poses"));
  body.motion.T_map_body.push_back({});
  EXPECT_THAT(ErrorOfBody(body), HasSubstr("must ascend, but 1 s follows 1 s"));
  std::vector<Hit> none;
  const std::vector<Ray> one(1);
  EXPECT_THROW(RayScene({"empty", {}, {}}).Cast(one, none), Error);
}

}  // namespace
}  // namespace ariadne::drivers
