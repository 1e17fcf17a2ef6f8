#include "drivers/simulated/box_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;
using testing::DoubleNear;
using testing::Eq;
using testing::Optional;

/// A cube from 1 to 2 on each axis, and a wall behind it at x = 5.
BoxWorld CubeBeforeWall() {
  return {{slam::Box3(Vector3d(1, 1, 1), Vector3d(2, 2, 2)),
           slam::Box3(Vector3d(5, -9, -9), Vector3d(6, 9, 9))}};
}

auto HitAt(double distance) { return Optional(DoubleNear(distance, 1e-15)); }

TEST(CastRay, HitsTheNearestSurface) {
  const BoxWorld world = CubeBeforeWall();
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, Vector3d::UnitX()), HitAt(1.0))
      << "the cube is before the wall";
  EXPECT_THAT(CastRay(world, {3.0, 1.5, 1.5}, Vector3d::UnitX()), HitAt(2.0));
  EXPECT_THAT(CastRay(world, {3.0, 1.5, 1.5}, -Vector3d::UnitX()), HitAt(1.0));
  EXPECT_THAT(CastRay(world, {9.0, 1.5, 1.5}, -Vector3d::UnitX()), HitAt(3.0));
  EXPECT_THAT(CastRay(world, {1.5, -3.0, 1.5}, Vector3d::UnitY()), HitAt(4.0));
  EXPECT_THAT(CastRay(world, {1.5, 1.5, 4.0}, -Vector3d::UnitZ()), HitAt(2.0));
}

TEST(CastRay, HitsObliquely) {
  const BoxWorld world = CubeBeforeWall();
  EXPECT_THAT(CastRay(world, Vector3d::Zero(), Vector3d(1, 1, 1).normalized()), HitAt(std::numbers::sqrt3));
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, Vector3d(4, -3, 0) / 5), HitAt(6.25))
      << "past the cube, to the wall";
  EXPECT_THAT(CastRay(world, {0.0, 0.5, 1.5}, Vector3d(4, 3, 0) / 5), HitAt(1.25));
}

TEST(CastRay, MissesWhatIsBesideOrBehind) {
  const BoxWorld world = CubeBeforeWall();
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, -Vector3d::UnitX()), Eq(std::nullopt));
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, Vector3d::UnitY()), Eq(std::nullopt));
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, Vector3d(-4, 3, 0) / 5), Eq(std::nullopt));
  EXPECT_THAT(CastRay(BoxWorld{}, Vector3d::Zero(), Vector3d::UnitX()), Eq(std::nullopt));
}

TEST(CastRay, TakesARayInThePlaneOfAFace) {
  const BoxWorld world = CubeBeforeWall();
  EXPECT_THAT(CastRay(world, {0.0, 1.0, 1.5}, Vector3d::UnitX()), HitAt(1.0)) << "a box is closed";
  EXPECT_THAT(CastRay(world, {0.0, 2.0, 2.0}, Vector3d::UnitX()), HitAt(1.0)) << "along an edge";
  EXPECT_THAT(CastRay(world, {0.0, 0.999, 1.5}, Vector3d::UnitX()), HitAt(5.0));
  EXPECT_THAT(CastRay(world, {0.0, 1.5, 1.5}, Vector3d(1.0, -0.0, 0.0)), HitAt(1.0)) << "negative zero";
}

/// Whether the robot can be at a place: nothing is within its radius between the floor and 2 m.
bool IsFree(const BoxWorld& world, double x, double y, double radius) {
  return std::ranges::all_of(world.solids, [&](const slam::Box3& solid) {
    if (solid.max().z() <= 0.0 || solid.min().z() >= 2.0) return true;
    const double dx = std::max({solid.min().x() - x, 0.0, x - solid.max().x()});
    const double dy = std::max({solid.min().y() - y, 0.0, y - solid.max().y()});
    return std::hypot(dx, dy) > radius;
  });
}

TEST(OfficeTour, StopsInFreeSpace) {
  const BoxWorld office = MakeOffice();
  EXPECT_EQ(OfficeTour().size(), 8u);
  for (const slam::Pose2& stop : OfficeTour()) {
    EXPECT_TRUE(IsFree(office, stop.translation.x(), stop.translation.y(), 0.45))
        << stop.translation.transpose();
  }
}

TEST(OfficeTour, VisitsCorridorAndBothOffices) {
  int corridor = 0, left = 0, right = 0;
  for (const slam::Pose2& stop : OfficeTour()) {
    corridor += std::abs(stop.translation.y()) < 1.0;
    left += stop.translation.y() > 1.15;
    right += stop.translation.y() < -1.15;
  }
  EXPECT_GT(corridor, 2);
  EXPECT_GT(left, 0);
  EXPECT_GT(right, 0);
}

TEST(MakeOffice, IsClosed) {
  // No ray leaves it, from anywhere on the tour.
  const BoxWorld office = MakeOffice();
  RandomStream stream = NamedStream(1, "box_world_test");
  for (const slam::Pose2& stop : OfficeTour()) {
    for (int i = 0; i < 500; ++i) {
      const Vector3d direction(DrawNormal(stream, 0, 1), DrawNormal(stream, 0, 1),
                               DrawNormal(stream, 0, 1));
      const Vector3d origin(stop.translation.x(), stop.translation.y(), 1.0);
      EXPECT_THAT(CastRay(office, origin, direction.normalized()), Optional(testing::Lt(15.0)));
    }
  }
}

TEST(MakeOffice, HasTheHeightAndTheDoorsThatItSays) {
  const BoxWorld office = MakeOffice();
  EXPECT_THAT(CastRay(office, {7.0, 0.0, 1.0}, Vector3d::UnitZ()), HitAt(1.7));
  EXPECT_THAT(CastRay(office, {7.0, 0.0, 1.0}, -Vector3d::UnitZ()), HitAt(1.0));
  EXPECT_THAT(CastRay(office, {7.0, 0.0, 1.0}, Vector3d::UnitY()), HitAt(1.0));
  EXPECT_THAT(CastRay(office, {3.1, 0.0, 1.2}, Vector3d::UnitY()), HitAt(6.0)) << "through the left door";
  EXPECT_THAT(CastRay(office, {3.1, 0.0, 2.1}, Vector3d::UnitY()), HitAt(1.0)) << "the lintel above it";
  EXPECT_THAT(CastRay(office, {10.7, 0.0, 1.2}, -Vector3d::UnitY()), HitAt(6.0))
      << "through the right door";
}

}  // namespace
}  // namespace ariadne::drivers
