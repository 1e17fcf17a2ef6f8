#include "slam/geometry/polygon2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

Ring Rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

double AreaOf(const std::vector<Polygon2>& polygons) {
  double area = 0.0;
  for (const Polygon2& polygon : polygons) area += Area(polygon);
  return area;
}

TEST(Polygon2, HasAnAreaWithoutItsHoles) {
  Polygon2 polygon{Rectangle(0, 0, 4, 3), {Rectangle(1, 1, 2, 2)}};
  std::ranges::reverse(polygon.holes[0]);
  EXPECT_DOUBLE_EQ(SignedArea(polygon.outer), 12.0);
  EXPECT_DOUBLE_EQ(SignedArea(polygon.holes[0]), -1.0);
  EXPECT_DOUBLE_EQ(Area(polygon), 11.0);
  EXPECT_DOUBLE_EQ(Perimeter(polygon), 18.0);
  EXPECT_TRUE(Contains(polygon, {0.5, 1.5}));
  EXPECT_FALSE(Contains(polygon, {1.5, 1.5}));
  EXPECT_FALSE(Contains(polygon, {4.5, 1.5}));
}

TEST(Polygon2, WithoutCornersIsNothing) {
  EXPECT_EQ(SignedArea({}), 0.0);
  EXPECT_EQ(Area({}), 0.0);
  EXPECT_FALSE(Contains({}, {0.0, 0.0}));
  EXPECT_TRUE(United(std::vector<Ring>{{}, {{0, 0}, {1, 1}}}).empty());
}

TEST(United, JoinsWhatOverlapsWhateverTheSense) {
  std::vector<Ring> rings{Rectangle(0, 0, 2, 2), Rectangle(1, 1, 3, 3), Rectangle(5, 0, 6, 1)};
  std::ranges::reverse(rings[1]);
  const std::vector<Polygon2> united = United(rings);
  ASSERT_EQ(united.size(), 2u);
  EXPECT_NEAR(AreaOf(united), 8.0, 1e-9);
  for (const Polygon2& polygon : united) EXPECT_GT(SignedArea(polygon.outer), 0.0);
}

TEST(United, LeavesAHoleWithinAFrame) {
  const std::vector<Ring> frame{Rectangle(0, 0, 4, 1), Rectangle(0, 3, 4, 4), Rectangle(0, 0, 1, 4),
                                Rectangle(3, 0, 4, 4)};
  const std::vector<Polygon2> united = United(frame);
  ASSERT_EQ(united.size(), 1u);
  ASSERT_EQ(united[0].holes.size(), 1u);
  EXPECT_NEAR(SignedArea(united[0].holes[0]), -4.0, 1e-9);
  // Something within the hole is a polygon of its own, and filling it leaves none.
  const std::vector<Polygon2> island{united[0], {Rectangle(1.5, 1.5, 2.5, 2.5), {}}};
  EXPECT_EQ(United(island).size(), 2u);
  const std::vector<Polygon2> filled{united[0], {Rectangle(0.5, 0.5, 3.5, 3.5), {}}};
  ASSERT_EQ(United(filled).size(), 1u);
  EXPECT_TRUE(United(filled)[0].holes.empty());
}

TEST(United, TakesARingThatCrossesItself) {
  const std::vector<Ring> eight{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}};
  EXPECT_NEAR(AreaOf(United(eight)), 2.0, 1e-9);
}

TEST(United, RefusesCornersThatAreNoPlaces) {
  std::vector<Ring> rings{Rectangle(0, 0, 1, 1)};
  rings[0][2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { United(rings); }), testing::HasSubstr("no place"));
  rings[0][2].x() = 1e12;
  EXPECT_THAT(ErrorOf([&] { United(rings); }), testing::HasSubstr("no place"));
}

TEST(United, EnclosesWhatARingEncloses) {
  RandomStream stream = NamedStream(7, "polygon2");
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Ring> rings;
    for (int r = 0; r < 6; ++r) {
      const double x = DrawUniform(stream, -2.0, 2.0), y = DrawUniform(stream, -2.0, 2.0);
      rings.push_back(
          Rectangle(x, y, x + DrawUniform(stream, 0.1, 2.0), y + DrawUniform(stream, 0.1, 2.0)));
    }
    const std::vector<Polygon2> united = United(rings);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d p(DrawUniform(stream, -3.0, 4.0), DrawUniform(stream, -3.0, 4.0));
      const bool expected = std::ranges::any_of(rings, [&](const Ring& r) { return Contains({r, {}}, p); });
      EXPECT_EQ(std::ranges::any_of(united, [&](const Polygon2& u) { return Contains(u, p); }), expected);
    }
  }
}

}  // namespace
}  // namespace ariadne::slam
