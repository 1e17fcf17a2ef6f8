#include "planning/polygon/labelled_union.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/random.h"
#include "slam/geometry/pose2.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;
constexpr double kHalfCircle = std::numbers::pi;
constexpr LabelledUnionOptions kExact{0.0, 0.0};

/// A rectangle whose edges (below, right, above, left) have these labels.
LabelledPolygon Rectangle(const Vector2d& low, const Vector2d& high, const std::array<bool, 4>& seen) {
  return {{{low, seen[0]}, {{high.x(), low.y()}, seen[1]}, {high, seen[2]}, {{low.x(), high.y()}, seen[3]}},
          {}};
}

LabelledPolygon Moved(const slam::Pose2& T_a_b, LabelledPolygon polygon) {
  for (LabelledCorner& corner : polygon.outer) corner.p_map = T_a_b * corner.p_map;
  return polygon;
}

double SeenLength(const std::vector<LabelledPolygon>& polygons) {
  double length = 0.0;
  for (const LabelledPolygon& polygon : polygons) length += planning::SeenLength(polygon);
  return length;
}

double UnseenLength(const std::vector<LabelledPolygon>& polygons) {
  double length = 0.0;
  for (const LabelledPolygon& polygon : polygons) length += planning::UnseenLength(polygon);
  return length;
}

LabelledPolygon DrawStar(RandomStream& stream) {
  const Vector2d center(DrawUniform(stream, -3.0, 3.0), DrawUniform(stream, -3.0, 3.0));
  const int corners = static_cast<int>(DrawUniform(stream, 3.0, 14.0));
  const double start = DrawUniform(stream, 0.0, kHalfCircle);
  LabelledPolygon star;
  for (int i = 0; i < corners; ++i) {
    const double bearing = start + 2.0 * kHalfCircle * i / corners;
    const Vector2d u(std::cos(bearing), std::sin(bearing));
    star.outer.push_back({center + DrawUniform(stream, 0.5, 4.0) * u, DrawUniform(stream, 0.0, 1.0) < 0.5});
  }
  return star;
}

/// On a grid of 1 m, so that edges of several lie on each other; every other one turned by noise.
LabelledPolygon DrawRectangle(RandomStream& stream) {
  const auto whole = [&](double low, double high) { return std::floor(DrawUniform(stream, low, high)); };
  const Vector2d low(whole(-4.0, 4.0), whole(-4.0, 4.0));
  const Vector2d high = low + Vector2d(whole(1.0, 4.0), whole(1.0, 4.0));
  std::array<bool, 4> seen{};
  for (bool& one : seen) one = DrawUniform(stream, 0.0, 1.0) < 0.5;
  const LabelledPolygon rectangle = Rectangle(low, high, seen);
  if (DrawUniform(stream, 0.0, 1.0) < 0.5) return rectangle;
  const Vector2d shift(DrawNormal(stream, 0.0, 0.03), DrawNormal(stream, 0.0, 0.03));
  return Moved({DrawNormal(stream, 0.0, 0.017), shift}, rectangle);
}

/// The oracle, which shares nothing with the union: how often a ring goes round p.
int Winding(const LabelledRing& ring, const Vector2d& p) {
  double turned = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d a = ring[i].p_map - p;
    const Vector2d b = ring[(i + 1) % ring.size()].p_map - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return static_cast<int>(std::lround(turned / (2.0 * kHalfCircle)));
}

double DistanceToEdge(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

struct Nearby {
  double seen = std::numeric_limits<double>::infinity();    // distance to the nearest edge of that label
  double unseen = std::numeric_limits<double>::infinity();  // [m]
};

Nearby NearestEdges(const std::vector<LabelledPolygon>& inputs, const Vector2d& p) {
  Nearby nearby;
  for (const LabelledPolygon& input : inputs) {
    for (std::size_t i = 0; i < input.outer.size(); ++i) {
      const LabelledCorner& a = input.outer[i];
      const double distance = DistanceToEdge(p, a.p_map, input.outer[(i + 1) % input.outer.size()].p_map);
      double& nearest = a.seen ? nearby.seen : nearby.unseen;
      nearest = std::min(nearest, distance);
    }
  }
  return nearby;
}

bool Covered(const std::vector<LabelledPolygon>& inputs, const Vector2d& p) {
  return std::ranges::any_of(inputs,
                             [&](const LabelledPolygon& input) { return Winding(input.outer, p) != 0; });
}

/// Checks an edge piece of more than 1 mm, at places along it: there is an edge of that label, and where an
/// edge of the other label is too, it is seen; the area begins to the left, and nothing is to the right.
void CheckPiece(const std::vector<LabelledPolygon>& inputs, const LabelledCorner& from,
                const Vector2d& to) {
  constexpr double kRounding = 4e-4;
  constexpr std::array kBeside{1e-4, 1.5e-4, 2e-4, 3e-4, 5e-4, 1e-3};  // [m]
  const Vector2d along = to - from.p_map;
  if (along.norm() < 1e-3) return;
  const Vector2d left = Vector2d(-along.y(), along.x()).normalized();
  for (const double share : {0.5, 0.5e-3 / along.norm(), 1.0 - 0.5e-3 / along.norm()}) {
    const Vector2d p = from.p_map + share * along;
    const Nearby nearby = NearestEdges(inputs, p);
    if (from.seen) {
      EXPECT_LT(nearby.seen, kRounding);
    } else if (share == 0.5) {
      EXPECT_LT(nearby.unseen, kRounding);
    }
    if (share == 0.5 && along.norm() > 0.01) {
      // The area, and the space outside of it, may be a wedge hardly wider than the rounding.
      EXPECT_TRUE(std::ranges::any_of(kBeside, [&](double d) { return Covered(inputs, p + d * left); }));
      EXPECT_FALSE(std::ranges::all_of(kBeside, [&](double d) { return Covered(inputs, p - d * left); }));
    }
  }
}

void CheckUnion(const std::vector<LabelledPolygon>& inputs) {
  double area = 0.0;
  for (const LabelledPolygon& polygon : LabelledUnion(inputs, kExact)) {
    std::vector<LabelledRing> rings = polygon.holes;
    rings.push_back(polygon.outer);
    for (const LabelledRing& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        CheckPiece(inputs, ring[i], ring[(i + 1) % ring.size()].p_map);
    }
    area += slam::Area(ToPolygon2(polygon));
  }
  std::vector<slam::Polygon2> plain;
  for (const LabelledPolygon& input : inputs) plain.push_back(ToPolygon2(input));
  double expected = 0.0;
  for (const slam::Polygon2& polygon : slam::United(plain)) expected += slam::Area(polygon);
  EXPECT_NEAR(area, expected, 1e-6);  // cutting edges moves nothing
}

TEST(LabelledUnion, AnOpeningBetweenWallsInOneLineSurvives) {
  const LabelledPolygon room{{{{0.0, 0.0}, true},
                              {{1.0, 0.0}, false},
                              {{1.9, 0.0}, true},
                              {{4.0, 0.0}, true},
                              {{4.0, 3.0}, true},
                              {{0.0, 3.0}, true}},
                             {}};
  const auto alone = LabelledUnion(std::vector{room}, kExact);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_NEAR(UnseenLength(alone), 0.9, 1e-3);
  EXPECT_NEAR(SeenLength(alone), 13.1, 1e-3);
}

TEST(LabelledUnion, SeenWinsWhereBothLieOnEachOther) {
  const auto unseen = Rectangle({0.0, 0.0}, {4.0, 3.0}, {false, false, false, false});
  const auto seen = Rectangle({1.0, 0.0}, {3.0, 2.0}, {true, true, true, true});
  for (const auto& both : {std::vector{unseen, seen}, std::vector{seen, unseen}}) {
    const auto united = LabelledUnion(both, kExact);
    EXPECT_NEAR(SeenLength(united), 2.0, 1e-3);
    EXPECT_NEAR(UnseenLength(united), 12.0, 1e-3);
  }
}

TEST(LabelledUnion, HolesKeepTheirLabels) {
  const std::vector<LabelledPolygon> around{Rectangle({0.0, 0.0}, {6.0, 2.0}, {true, true, false, true}),
                                            Rectangle({0.0, 4.0}, {6.0, 6.0}, {true, true, true, true}),
                                            Rectangle({0.0, 0.0}, {2.0, 6.0}, {true, true, true, true}),
                                            Rectangle({4.0, 0.0}, {6.0, 6.0}, {true, true, true, true})};
  const auto united = LabelledUnion(around);
  ASSERT_EQ(united.size(), 1U);
  ASSERT_EQ(united[0].holes.size(), 1U);
  EXPECT_NEAR(planning::UnseenLength({united[0].holes[0], {}}), 2.0, 1e-3);  // above the lowest
  EXPECT_FALSE(Contains(united[0], {3.0, 3.0}));
  EXPECT_NEAR(UnseenLength(LabelledUnion(united)), UnseenLength(united), 1e-6);  // again: holes as input
}

TEST(LabelledUnion, AgreesWithAnIndependentOracle) {
  RandomStream stream = NamedStream(3, "test/labelled_union");
  for (int round = 0; round < 1500 && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    std::vector<LabelledPolygon> inputs(static_cast<std::size_t>(DrawUniform(stream, 1.0, 7.0)));
    for (LabelledPolygon& input : inputs) {
      const bool star = round % 3 == 0 || (round % 3 == 1 && DrawUniform(stream, 0.0, 1.0) < 0.5);
      input = star ? DrawStar(stream) : DrawRectangle(stream);
    }
    CheckUnion(inputs);
  }
}

// Two scans of a room with a door, each with a part of a wall that it has not found, and poses that err.
TEST(LabelledUnion, RegistrationNoiseDestroysNeitherWallsNorDoors) {
  const auto room = [](double gap) {
    return LabelledPolygon{{{{0.0, 0.0}, true},
                            {{1.0, 0.0}, false},
                            {{1.9, 0.0}, true},
                            {{5.0, 0.0}, true},
                            {{5.0, 4.0}, true},
                            {{gap + 1.0, 4.0}, false},
                            {{gap, 4.0}, true},
                            {{0.0, 4.0}, true}},
                           {}};
  };
  RandomStream stream = NamedStream(5, "test/labelled_union/noise");
  for (int round = 0; round < 200; ++round) {
    const auto noise = [&] {
      const Vector2d shift(DrawUniform(stream, -0.015, 0.015), DrawUniform(stream, -0.015, 0.015));
      const double angle = DrawUniform(stream, -0.5, 0.5) / 180.0 * kHalfCircle;
      const Vector2d center(2.5, 2.0);
      return slam::Pose2{0.0, center + shift} * slam::Pose2{angle, -center};
    };
    const auto united = LabelledUnion(std::vector{Moved(noise(), room(3.0)), Moved(noise(), room(1.0))});
    EXPECT_NEAR(UnseenLength(united), 0.9, 0.15) << round;
  }
}

TEST(LabelledUnion, MovesWithTheFrame) {
  RandomStream stream = NamedStream(4, "test/labelled_union/frame");
  const slam::Pose2 T_a_b{1.1, {30.0, -20.0}};
  for (int round = 0; round < 50; ++round) {
    const std::vector<LabelledPolygon> here{DrawStar(stream), DrawStar(stream), DrawRectangle(stream)};
    std::vector<LabelledPolygon> there;
    for (const LabelledPolygon& polygon : here) there.push_back(Moved(T_a_b, polygon));
    EXPECT_NEAR(SeenLength(LabelledUnion(here, kExact)), SeenLength(LabelledUnion(there, kExact)), 0.02);
  }
}

TEST(LabelledUnion, DamagedInputIsAnError) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error_of = [](LabelledPolygon polygon) {
    return ErrorOf([&] { LabelledUnion(std::vector{polygon}); });
  };
  EXPECT_THAT(error_of(Rectangle({0.0, nan}, {1.0, 1.0}, {})), HasSubstr("no place"));
  EXPECT_THAT(error_of(Rectangle({0.0, 0.0}, {1e6, 1.0}, {})), HasSubstr("no place"));
  EXPECT_THAT(error_of({{{{0.0, 0.0}, true}, {{1.0, 0.0}, true}}, {}}), HasSubstr("2 corners"));
  EXPECT_THAT(error_of({{}, {{{{0.0, 0.0}, true}}}}), HasSubstr("no outer ring"));
  EXPECT_THAT(
      error_of({{{{0.0, 0.0}, true}, {{1.0, 1.0}, true}, {{1.0, 0.0}, true}, {{0.0, 1.0}, true}}, {}}),
      HasSubstr("cross"));
  EXPECT_THAT(ErrorOf([&] { LabelledUnion({}, {-1.0, 0.0}); }), HasSubstr("tolerance"));
  EXPECT_TRUE(LabelledUnion({}).empty());
  EXPECT_TRUE(LabelledUnion(std::vector{LabelledPolygon{}}).empty());
}

}  // namespace
}  // namespace ariadne::planning
