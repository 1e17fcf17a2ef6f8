#include "planning/path/roadmap.h"

#include <gtest/gtest.h>

#include <limits>

#include "planning/path/geodesic.h"
#include "tests/planning/path/random_rooms.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

constexpr double kRoadRadius = 0.3;

TEST(Roadmap, ItsPlacesAndWaysAreFree) {
  const PillarRoom room = RandomPillarRoom(4);
  const FreeSpace space(std::span(&room.area, 1));
  RoadmapOptions options;
  options.vertices = 200;
  const Roadmap roadmap = BuildRoadmap(space, kRoadRadius, options, 1);
  ASSERT_EQ(roadmap.vertices_map.size(), 200u);
  EXPECT_GT(roadmap.ways.size(), 400u);
  for (const Eigen::Vector2d& p : roadmap.vertices_map)
    EXPECT_GE(TrueClearance(room.area, p), kRoadRadius - 1e-6);
  for (const Roadmap::Way& way : roadmap.ways) {
    const Eigen::Vector2d from = roadmap.vertices_map[way.from], to = roadmap.vertices_map[way.to];
    EXPECT_NEAR(way.length, (to - from).norm(), 1e-12);
    for (double s = 0.0; s < 1.0; s += 0.04) {
      EXPECT_GE(TrueClearance(room.area, from + s * (to - from)), kRoadRadius - 0.005);
    }
  }
}

TEST(Roadmap, LengthsAreNearTheGeodesics) {
  double sum = 0.0;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    RoadmapOptions options;
    options.vertices = 300;
    const Roadmap roadmap = BuildRoadmap(space, kRoadRadius, options, seed);
    const Eigen::Vector2d start = DrawFree(room, 0.45, stream);
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 15; ++i) places.push_back(DrawFree(room, 0.45, stream));
    const std::vector<double> lengths = RoadmapDistances(space, roadmap, start, places);
    const GeodesicField field = DistancesFrom(space, start, kRoadRadius);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (std::isinf(lengths[i])) continue;
      const double shortest = LengthOf(field.PathTo(places[i]));
      EXPECT_GE(lengths[i], shortest * 0.98 - 0.05);
      EXPECT_LE(lengths[i], shortest * 1.25 + 0.1);
      sum += lengths[i] / shortest;
      ++compared;
    }
  }
  EXPECT_GT(compared, 55);
  EXPECT_LT(sum / compared, 1.03);
}

TEST(Roadmap, IsRepeatable) {
  const PillarRoom room = RandomPillarRoom(2);
  const FreeSpace space(std::span(&room.area, 1));
  RoadmapOptions options;
  options.vertices = 100;
  const Roadmap first = BuildRoadmap(space, kRoadRadius, options, 1),
                other = BuildRoadmap(space, kRoadRadius, options, 2);
  const Roadmap again = BuildRoadmap(space, kRoadRadius, options, 1);
  EXPECT_EQ(first.vertices_map, again.vertices_map);
  ASSERT_EQ(first.ways.size(), again.ways.size());
  for (std::size_t i = 0; i < first.ways.size(); ++i) {
    EXPECT_EQ(first.ways[i].from, again.ways[i].from);
    EXPECT_EQ(first.ways[i].to, again.ways[i].to);
  }
  EXPECT_NE(first.vertices_map, other.vertices_map);
}

TEST(Roadmap, IsSmallWhereThereIsNoRoom) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 2.0, 2.0), {}}};
  EXPECT_TRUE(BuildRoadmap(FreeSpace(area), 1.1, {}, 1).vertices_map.empty());
  EXPECT_TRUE(BuildRoadmap(FreeSpace({}), 0.3, {}, 1).vertices_map.empty());
  const std::array places{Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(9.0, 1.0)};
  const FreeSpace space(area);
  const auto lengths = RoadmapDistances(space, BuildRoadmap(space, 0.3, {}, 1), {1.0, 0.5}, places);
  EXPECT_DOUBLE_EQ(lengths[0], 0.5);
  EXPECT_EQ(lengths[1], std::numeric_limits<double>::infinity());
  EXPECT_NE(ErrorOf([&] { BuildRoadmap(space, std::nan(""), {}, 1); }), "");
  EXPECT_NE(ErrorOf([&] {
              BuildRoadmap(space, 0.3, {0, 50}, 1);
            }).find("roadmap.vertices"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
