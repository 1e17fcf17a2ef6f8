#include "planning/path/geodesic.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <queue>

#include "tests/planning/path/random_rooms.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Place = Eigen::Vector2d;
using Places = std::vector<Place>;
constexpr double kInf = std::numeric_limits<double>::infinity();

double CrossOf(const Place& a, const Place& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A convex ring moved outwards by a disc, its round corners as polygons within them.
slam::Ring Inflated(const slam::Ring& ring, double radius) {
  slam::Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Place after = ring[(i + 1) % ring.size()] - ring[i];
    const double from = std::atan2(-before.x(), before.y());  // of the outer normal
    double turn = std::atan2(-after.x(), after.y()) - from;
    if (turn < 0.0) turn += 2.0 * std::numbers::pi;
    for (int k = 0; k <= 6; ++k) {
      const double angle = from + turn * k / 6;
      result.push_back(ring[i] + radius * Place(std::cos(angle), std::sin(angle)));
    }
  }
  return result;
}

/// How much of a segment lies within a convex ring [m].
double LengthWithin(const slam::Ring& ring, const Place& a, const Place& b) {
  double low = 0.0, high = 1.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place along = ring[(i + 1) % ring.size()] - ring[i];
    const double at_a = CrossOf(along, a - ring[i]), at_b = CrossOf(along, b - ring[i]);
    if (at_a <= 0.0 && at_b <= 0.0) return 0.0;
    if (at_a < 0.0) low = std::max(low, at_a / (at_a - at_b));
    if (at_b < 0.0) high = std::min(high, at_a / (at_a - at_b));
  }
  return std::max(0.0, high - low) * (b - a).norm();
}

/// Lengths of the shortest ways of a disc from the first of some places to the others, by the graph of
/// places that see each other.
std::vector<double> VisibilityLengths(const PillarRoom& room, double radius, const Places& places) {
  std::vector<slam::Ring> pillars;
  for (const slam::Ring& pillar : room.pillars) pillars.push_back(Inflated(pillar, radius));
  const auto inside_room = [&](const Place& p) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Place along = (room.room[(i + 1) % 4] - room.room[i]).normalized();
      if (CrossOf(along, p - room.room[i]) < radius - 1e-9) return false;
    }
    return true;
  };
  const auto sees = [&](const Place& a, const Place& b) {
    return std::ranges::all_of(pillars,
                               [&](const auto& pillar) { return LengthWithin(pillar, a, b) < 1e-6; });
  };
  Places nodes = places;
  for (const slam::Ring& pillar : pillars)
    std::ranges::copy_if(pillar, std::back_inserter(nodes), inside_room);
  std::vector<double> distance(nodes.size(), kInf);
  std::vector<bool> done(nodes.size(), false);
  distance[0] = 0.0;
  for (;;) {
    std::size_t next = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && distance[i] < kInf && (next == nodes.size() || distance[i] < distance[next]))
        next = i;
    }
    if (next == nodes.size()) break;
    done[next] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double longer = distance[next] + (nodes[i] - nodes[next]).norm();
      if (!done[i] && longer < distance[i] && sees(nodes[next], nodes[i])) distance[i] = longer;
    }
  }
  distance.resize(places.size());
  return distance;
}

TEST(Geodesics, AgreeWithTheVisibilityGraph) {
  int compared = 0;
  double ratio = 0.0, tight_ratio = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    constexpr double kRadius = 0.3;
    Places places;
    for (int i = 0; i < 12; ++i) places.push_back(DrawFree(room, 0.5, stream));
    const GeodesicField field = DistancesFrom(space, places[0], kRadius);
    const std::vector<double> shortest = VisibilityLengths(room, kRadius - 0.005, places);
    const std::vector<double> wide = VisibilityLengths(room, kRadius + 0.075, places);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double length = field.To(places[i]);
      const Places way = field.PathTo(places[i]);
      EXPECT_GE(length, shortest[i] - 1e-3) << seed;
      EXPECT_LE(length, 1.028 * wide[i] + 0.2) << seed;
      EXPECT_EQ(way.empty(), length == kInf);
      if (way.empty()) continue;
      EXPECT_EQ(way.front(), places[0]);
      EXPECT_EQ(way.back(), places[i]);
      EXPECT_GE(LengthOf(way), shortest[i] - 1e-3) << seed;
      EXPECT_LE(LengthOf(way), length + 1e-9);
      EXPECT_LE(LengthOf(way), 1.01 * wide[i] + 0.05) << seed;
      for (std::size_t k = 1; k < way.size(); ++k) {
        for (double s = 0.0; s <= 1.0; s += 0.05) {
          EXPECT_GE(TrueClearance(room.area, way[k - 1] + s * (way[k] - way[k - 1])), kRadius - 0.005);
        }
      }
      ratio += length / shortest[i];
      tight_ratio += LengthOf(way) / shortest[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 80);
  EXPECT_LT(ratio / compared, 1.025);
  EXPECT_LT(tight_ratio / compared, 1.006);
  EXPECT_GT(tight_ratio / compared, 1.0);
}

TEST(Geodesics, AStartBesideAWallIsLeftOnItsSide) {
  // A wall of no thickness, at both ends of which there is a way around; the start touches it.
  const slam::Ring wall{{4.0, 1.0}, {4.0, 5.0}, {4.001, 5.0}, {4.001, 1.0}};
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 8.0, 6.0), {wall}}};
  const FreeSpace space(area);
  for (const double gap : {0.0005, 0.01, 0.1, 0.25}) {
    const GeodesicField left = DistancesFrom(space, {4.0 - gap, 3.0}, 0.3);
    EXPECT_NEAR(left.To({3.0, 3.0}), 1.0 - gap, 0.1);
    EXPECT_GT(left.To({5.0, 3.0}), 4.0);
    EXPECT_LT(left.To({5.0, 3.0}), 6.0);
    EXPECT_EQ(left.PathTo({5.0, 3.0}).front(), Place(4.0 - gap, 3.0));
    const GeodesicField right = DistancesFrom(space, {4.001 + gap, 3.0}, 0.3);
    EXPECT_NEAR(right.To({5.0, 3.0}), 0.999 - gap, 0.1);
    EXPECT_GT(right.To({3.0, 3.0}), 4.0);
  }
  // Within the wall of the room, where the pose's error may have put it.
  EXPECT_NEAR(DistancesFrom(space, {-0.02, 3.0}, 0.3).To({1.0, 3.0}), 1.02, 0.1);
  EXPECT_EQ(DistancesFrom(space, {-0.6, 3.0}, 0.3).To({1.0, 3.0}), kInf);
}

TEST(Geodesics, DoorsAreWideEnoughOrNot) {
  for (const double door : {0.5, 0.68, 0.82, 0.9}) {
    const slam::Ring area{{0.0, 0.0},        {4.0, 0.0},        {4.0, 2.0},        {4.2, 2.0},
                          {4.2, 0.0},        {8.0, 0.0},        {8.0, 4.0 + door}, {4.2, 4.0 + door},
                          {4.2, 2.0 + door}, {4.0, 2.0 + door}, {4.0, 4.0 + door}, {0.0, 4.0 + door}};
    const std::array rooms{slam::Polygon2{area, {}}};
    const FreeSpace space(rooms);
    const double length = DistancesFrom(space, {1.0, 2.0}, 0.35).To({7.0, 2.0});
    EXPECT_EQ(length<kInf, door> 0.7) << door;
  }
}

TEST(Geodesics, PlacesWithoutRoomAndNear) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 8.0, 6.0), {}}};
  const FreeSpace space(area);
  const GeodesicField field = DistancesFrom(space, {2.0, 3.0}, 0.3);
  EXPECT_EQ(field.To({2.0, 3.0}), 0.0);
  EXPECT_NEAR(field.To({2.07, 3.0}), 0.07, 1e-12);
  EXPECT_NEAR(field.To({2.0, 0.16}), 2.84, 0.1);
  EXPECT_EQ(field.To({2.0, 0.01}), kInf);
  EXPECT_EQ(field.To({2.0, -1.0}), kInf);
  EXPECT_EQ(field.To({std::nan(""), 1.0}), kInf);
  EXPECT_TRUE(field.PathTo({2.0, -1.0}).empty());
  EXPECT_EQ(field.PathTo({7.0, 1.0}), (Places{{2.0, 3.0}, {7.0, 1.0}}));
  EXPECT_EQ(LengthOf(field.PathTo({2.0, 3.0})), 0.0);
}

TEST(Geodesics, AreRepeatable) {
  const PillarRoom room = RandomPillarRoom(5);
  const FreeSpace space(std::span(&room.area, 1));
  RandomStream stream = NamedStream(1, "test");
  const Place start = DrawFree(room, 0.4, stream);
  for (int i = 0; i < 20; ++i) {
    const Place p = DrawFree(room, 0.4, stream);
    EXPECT_EQ(DistancesFrom(space, start, 0.3).To(p), DistancesFrom(space, start, 0.3).To(p));
    EXPECT_EQ(DistancesFrom(space, start, 0.3).PathTo(p), DistancesFrom(space, start, 0.3).PathTo(p));
  }
}

TEST(Geodesics, RefuseWhatIsNoStart) {
  const FreeSpace nothing({});
  EXPECT_EQ(DistancesFrom(nothing, {0.0, 0.0}, 0.3).To({0.0, 0.1}), kInf);
  EXPECT_EQ(ErrorOf([&] { DistancesFrom(nothing, {0.0, kInf}, 0.3); }), "the start (0, inf) is no place");
  EXPECT_EQ(ErrorOf([&] {
              DistancesFrom(nothing, {0.0, 0.0}, -1.0);
            }),
            "the robot's radius is -1 m, but must be finite and not negative");
}

}  // namespace
}  // namespace ariadne::planning
