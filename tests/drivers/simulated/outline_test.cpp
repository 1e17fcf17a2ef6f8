#include "drivers/simulated/outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/random_geometry.h"

namespace ariadne::drivers {
namespace {

using slam::Pose2;

const Eigen::Vector2d kHalf(0.4, 0.3);

std::array<Eigen::Vector3d, 3> DrawTriangle(RandomStream& stream) {
  return {slam::DrawInCube(stream, 1.0), slam::DrawInCube(stream, 1.0), slam::DrawInCube(stream, 1.0)};
}

Outline OutlineOf(const std::vector<Eigen::Vector2d>& corners) {
  Outline outline;
  for (const Eigen::Vector2d& corner : corners) outline.Add(corner);
  return outline;
}

Outline Shifted(const Outline& outline, const Eigen::Vector2d& shift) {
  Outline shifted;
  for (const Eigen::Vector2d& corner : outline.corners()) shifted.Add(corner + shift);
  return shifted;
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Of a convex outline; `sign` is 1 where it runs counterclockwise, -1 where clockwise.
bool IsInside(const Outline& outline, const Eigen::Vector2d& p, double sign) {
  const auto corners = outline.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    if (sign * Cross(corners[(i + 1) % corners.size()] - a, p - a) < 0.0) return false;
  }
  return !outline.empty();
}

TEST(OutlineBetween, IsTheTriangleWhereItIsBetweenTheHeights) {
  const Outline floor = OutlineBetween({{{0, 0, 0.5}, {2, 0, 0.5}, {0, 1, 0.5}}}, {0.0, 1.0});
  EXPECT_THAT(floor.corners(),
              testing::ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 0), Eigen::Vector2d(0, 1)));
  EXPECT_TRUE(OutlineBetween({{{0, 0, 0.5}, {2, 0, 0.5}, {0, 1, 0.5}}}, {0.6, 1.0}).empty());
}

TEST(OutlineBetween, CutsAWallToAStretch) {
  // A wall in the plane y = 0 whose lower edge is 4 m long at z = 0, with its tip at z = 2.
  const Outline wall = OutlineBetween({{{0, 0, 0}, {4, 0, 0}, {0, 0, 2}}}, {0.5, 1.0});
  double longest = 0.0;
  for (const Eigen::Vector2d& corner : wall.corners()) {
    EXPECT_EQ(corner.y(), 0.0);
    longest = std::max(longest, corner.x());
  }
  EXPECT_DOUBLE_EQ(longest, 3.0);
}

TEST(OutlineBetween, HoldsThePointsWhoseHeightIsInTheRange) {
  RandomStream stream = NamedStream(1, "outline_test/points");
  int inside = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto triangle = DrawTriangle(stream);
    const Outline outline = OutlineBetween(triangle, {-0.3, 0.4});
    const Eigen::Vector2d p = slam::DrawInCube(stream, 1.0).head<2>();
    Eigen::Matrix3d barycentric;
    for (int i = 0; i < 3; ++i) barycentric.col(i) << triangle[static_cast<std::size_t>(i)].head<2>(), 1.0;
    const double area = barycentric.determinant();
    const Eigen::Vector3d weights = barycentric.inverse() * Eigen::Vector3d(p.x(), p.y(), 1.0);
    const double z = weights.dot(Eigen::Vector3d(triangle[0].z(), triangle[1].z(), triangle[2].z()));
    const double margin = std::min({weights.minCoeff(), z + 0.3, 0.4 - z});
    if (std::abs(margin) < 1e-6 || std::abs(area) < 1e-6) continue;
    EXPECT_EQ(IsInside(outline, p, area > 0.0 ? 1.0 : -1.0), margin > 0.0) << trial;
    inside += margin > 0.0;
  }
  EXPECT_GT(inside, 500);
}

TEST(OverlapDepth, IsZeroAtATouchAndGrowsFromThere) {
  const Outline wall = OutlineOf({{0.4, -5.0}, {0.4, 5.0}});
  EXPECT_EQ(OverlapDepth(wall, Pose2{}, kHalf), 0.0);
  EXPECT_NEAR(OverlapDepth(wall, Pose2{0.0, {0.1, 0.0}}, kHalf), 0.1, 1e-15);
  EXPECT_EQ(OverlapDepth(wall, Pose2{0.0, {-0.1, 0.0}}, kHalf), 0.0);
  EXPECT_NEAR(OverlapDepth(wall, Pose2{std::numbers::pi / 2, {0.2, 0.0}}, kHalf), 0.1, 1e-15);
}

TEST(OverlapDepth, KnowsPointsInside) {
  EXPECT_NEAR(OverlapDepth(OutlineOf({{0.1, 0.25}}), Pose2{}, kHalf), 0.05, 1e-15);
  EXPECT_EQ(OverlapDepth(OutlineOf({{0.1, 0.35}}), Pose2{}, kHalf), 0.0);
  EXPECT_EQ(OverlapDepth(Outline{}, Pose2{}, kHalf), 0.0);
}

TEST(OverlapDepth, SeesACornerThatOnlyAnEdgeSeparates) {
  const Outline diagonal = OutlineOf({{0.8, 0.0}, {0.0, 0.8}});  // the boxes around both overlap
  EXPECT_EQ(OverlapDepth(diagonal, Pose2{}, kHalf), 0.0);
  EXPECT_GT(OverlapDepth(diagonal, Pose2{0.0, {0.06, 0.06}}, kHalf), 0.0);
}

/// Whether both have points inside of each other, by cutting the outline at the rectangle's sides.
bool OverlapByCutting(const Outline& outline, const Pose2& T_map_base) {
  std::vector<Eigen::Vector2d> left;
  for (const Eigen::Vector2d& p : outline.corners()) left.push_back(T_map_base.Inverse() * p);
  for (int side = 0; side < 4; ++side) {
    const double sign = side < 2 ? 1.0 : -1.0;
    const int axis = side % 2;
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Eigen::Vector2d &p = left[i], &q = left[(i + 1) % left.size()];
      const double in_p = kHalf[axis] - sign * p[axis], in_q = kHalf[axis] - sign * q[axis];
      if (in_p > 0.0) kept.push_back(p);
      if (in_p * in_q < 0.0) kept.push_back(p + in_p / (in_p - in_q) * (q - p));
    }
    left = kept;
  }
  return !left.empty();
}

TEST(OverlapDepth, AgreesWithCutting) {
  RandomStream stream = NamedStream(2, "outline_test/cutting");
  int overlapping = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Outline outline = OutlineBetween(DrawTriangle(stream), {-0.5, 0.5});
    const Pose2 pose = Pose2::Exp(slam::DrawInCube(stream, 1.2));
    const double depth = OverlapDepth(outline, pose, kHalf);
    overlapping += depth > 0.0;
    if (depth > 0.0 && depth < 1e-9) continue;
    EXPECT_EQ(depth > 0.0, OverlapByCutting(outline, pose)) << trial;
  }
  EXPECT_GT(overlapping, 5000);
  EXPECT_LT(overlapping, 15000);
}

TEST(OverlapDepth, IsTheShortestWayOut) {
  RandomStream stream = NamedStream(3, "outline_test/way_out");
  constexpr int kDirections = 720;
  for (int trial = 0; trial < 300; ++trial) {
    const Outline outline = OutlineBetween(DrawTriangle(stream), {-0.5, 0.5});
    const Pose2 pose = Pose2::Exp(slam::DrawInCube(stream, 0.8));
    const double depth = OverlapDepth(outline, pose, kHalf);
    if (depth < 1e-3) continue;
    bool free_soon_after = false;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      EXPECT_GT(OverlapDepth(Shifted(outline, 0.999 * depth * direction), pose, kHalf), 0.0);
      free_soon_after |= OverlapDepth(Shifted(outline, 1.001 * depth * direction), pose, kHalf) == 0.0;
    }
    EXPECT_TRUE(free_soon_after) << trial;
  }
}

TEST(DistanceTo, IsThatOfTheNearestPointOfTheOutline) {
  RandomStream stream = NamedStream(4, "outline_test/distance");
  for (int trial = 0; trial < 200; ++trial) {
    const auto triangle = DrawTriangle(stream);
    const Outline outline = OutlineBetween(triangle, {-2.0, 2.0});
    const Eigen::Vector2d p = 2.0 * slam::DrawInCube(stream, 1.0).head<2>();
    constexpr int kSteps = 100;
    double nearest = 10.0;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps - i; ++k) {
        const double a = double(i) / kSteps, b = double(k) / kSteps;
        const Eigen::Vector3d on = a * triangle[0] + b * triangle[1] + (1.0 - a - b) * triangle[2];
        nearest = std::min(nearest, (on.head<2>() - p).norm());
      }
    }
    EXPECT_LE(DistanceTo(outline, p), nearest + 1e-12);
    EXPECT_GE(DistanceTo(outline, p), nearest - 0.03);
  }
}

TEST(DistanceTo, IsRightForPointsAndStretches) {
  EXPECT_NEAR(DistanceTo(OutlineOf({{1.0, 0.0}}), {1.0, 2.0}), 2.0, 1e-12);
  const Outline stretch = OutlineOf({{0.0, 0.0}, {2.0, 0.0}});
  EXPECT_NEAR(DistanceTo(stretch, {1.0, -0.5}), 0.5, 1e-12);
  EXPECT_NEAR(DistanceTo(stretch, {5.0, 4.0}), 5.0, 1e-12);
  EXPECT_NEAR(DistanceTo(stretch, {0.5, 0.0}), 0.0, 1e-12);
  EXPECT_TRUE(std::isinf(DistanceTo(Outline(), {0.0, 0.0})));
}

}  // namespace
}  // namespace ariadne::drivers
