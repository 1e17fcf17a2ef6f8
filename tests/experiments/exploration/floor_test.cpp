#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/simulated/plan_world.h"
#include "drivers/simulated/world.h"
#include "experiments/exploration/explore.h"
#include "experiments/exploration/floor_bound.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;

/// Two rooms of 6 x 5 m with a door of 0.9 m between them.
drivers::World TwoRoomPlan() {
  return drivers::ParsePlan(R"({"name": "two rooms", "unit": "m", "start": [1.5, 2.5], "area": 60,
    "walls": [[0, 0, 12, 0], [12, 0, 12, 5], [12, 5, 0, 5], [0, 5, 0, 0], [6, 0, 6, 2], [6, 2.9, 6, 5]],
    "doors": [[6, 2.45]], "spaces": []})",
                            "two_rooms.json");
}

Floor TwoRoomFloor() { return CutFloor(TwoRoomPlan(), 1.5); }

/// The distance to the nearest face along a ray, by brute force.
double RangeOf(const Floor& floor, const Vector2d& from, double bearing) {
  const Vector2d u(std::cos(bearing), std::sin(bearing));
  double range = 1e9;
  for (const FloorWall& face : floor.faces) {
    const Vector2d a = face.from - from, e = face.to - face.from;
    const double across = u.x() * e.y() - u.y() * e.x();
    if (std::abs(across) < 1e-12) continue;
    const double t = (a.x() * e.y() - a.y() * e.x()) / across, s = (a.x() * u.y() - a.y() * u.x()) / across;
    if (t > 0.0 && s >= 0.0 && s <= 1.0) range = std::min(range, t);
  }
  return range;
}

TEST(Floor, IsTheCutThroughTheWalls) {
  const Floor floor = TwoRoomFloor();
  EXPECT_NEAR(RangeOf(floor, {2.0, 1.0}, std::numbers::pi), 2.0 - 0.06, 1e-3) << "walls are 12 cm thick";
  EXPECT_NEAR(RangeOf(floor, {2.0, 1.0}, 0.0), 4.0 - 0.06, 1e-3);
  EXPECT_NEAR(RangeOf(floor, {2.0, 2.45}, 0.0), 10.0 - 0.06, 1e-3) << "through the door";
  EXPECT_TRUE(floor.enclosed) << "by the yard's wall";
  EXPECT_THAT(ErrorOf([] { CutFloor(TwoRoomPlan(), 50.0); }), testing::HasSubstr("nothing stands"));
}

TEST(FloorView, SeesWhatRaysMeet) {
  const Floor floor = TwoRoomFloor();
  RandomStream stream = NamedStream(1, "test/floor_view");
  for (const double field_of_view : {90.0, 180.0, 270.0, 360.0}) {
    const slam::Pose2 T_map_scan{DrawUniform(stream, -3.0, 3.0), {2.0, 2.0}};
    const FloorScannerOptions scanner{field_of_view, 7.0};
    const FloorView view = ViewFloor(floor, T_map_scan, scanner);
    for (int k = 0; k < 2000; ++k) {
      const double turn = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
      const double range = RangeOf(floor, T_map_scan.translation, T_map_scan.angle + turn);
      if (std::abs(range - 7.0) < 1e-3 || std::abs(std::abs(turn) - field_of_view * M_PI / 360.0) < 1e-3)
        continue;
      const Vector2d p = T_map_scan * Vector2d(range * std::cos(turn), range * std::sin(turn));
      EXPECT_EQ(IsSeen(view, p), range < 7.0 && std::abs(turn) < field_of_view * M_PI / 360.0)
          << field_of_view << " " << turn << " " << range;
    }
  }
}

TEST(FloorCover, IsWhatCanBeSeenFromWhereTheRobotCanBe) {
  const Floor floor = TwoRoomFloor();
  const FloorCoverOptions options;
  const std::vector<Vector2d> reachable = ReachableFloor(floor, options);
  EXPECT_TRUE(std::ranges::any_of(reachable, [](const Vector2d& p) { return p.x() > 7.0; }))
      << "by the door";
  for (const Vector2d& p : reachable) {
    EXPECT_TRUE(p.x() > 0.3 && p.x() < 11.7 && p.y() > 0.3 && p.y() < 4.7) << p.transpose();
  }
  const FloorCover cover = FindFloorCover(floor, reachable, {}, options, Parallel(1));
  const double inside = 2.0 * (11.88 + 4.88) + 2.0 * 4.1 - 2.0 * 0.12 + 2.0 * 0.12;
  EXPECT_NEAR(static_cast<double>(cover.places_map.size()) * cover.length_each, inside, 0.05 * inside);
}

struct Explored {
  FloorCover cover;
  FloorBound bound;
  double tour = 0.0;
};

Explored BoundOfTwoRooms(const Floor& floor) {
  const FloorScannerOptions scanner;
  const std::vector<Vector2d> reachable = ReachableFloor(floor, {});
  Explored explored{FindFloorCover(floor, reachable, scanner, {}, Parallel(1)), {}, 0.0};
  const planning::FreeSpace free = FreeFloor(floor, reachable, scanner, 1.0);
  FloorBoundOptions options;
  options.place_spacing = 1.0;
  explored.bound = FindFloorBound(floor, reachable, explored.cover, free, scanner, options, Parallel(1));
  explored.tour = TourLength(explored.bound, floor.T_map_start.translation, free, 0.3);
  return explored;
}

TEST(Explore, SeesAllAndEndsAndIsNoBetterThanTheBound) {
  const Floor floor = TwoRoomFloor();
  const Explored explored = BoundOfTwoRooms(floor);
  EXPECT_GE(explored.bound.covered, 0.95);
  EXPECT_GE(explored.bound.lower_bound, 2);
  EXPECT_GT(explored.tour, 3.0);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Exploration exploration = Explore(floor, explored.cover, floor.T_map_start, {}, seed);
    EXPECT_TRUE(exploration.ended);
    EXPECT_GT(exploration.steps.back().covered, 0.99);
    EXPECT_GE(ScansTo(exploration, 0.95), explored.bound.lower_bound);
    EXPECT_LE(ScansTo(exploration, 0.95), 3.0 * explored.bound.lower_bound);
    for (std::size_t i = 1; i < exploration.steps.size(); ++i) {
      EXPECT_GE(exploration.steps[i].covered, exploration.steps[i - 1].covered);
      EXPECT_GE(exploration.steps[i].path, exploration.steps[i - 1].path);
    }
  }
}

TEST(Explore, EndsWithEveryPolicyAlsoWhereAWindowShowsNothing) {
  // A gap in the wall behind which there is nothing at all: it would promise the same gain for ever.
  Floor floor = TwoRoomFloor();
  std::erase_if(floor.faces, [](const FloorWall& f) { return std::min(f.from.x(), f.to.x()) > 11.0; });
  floor.enclosed = false;
  const std::vector<Vector2d> reachable = [&] {
    std::vector<Vector2d> within = ReachableFloor(TwoRoomFloor(), {});
    return within;
  }();
  const FloorCover cover = FindFloorCover(floor, reachable, {}, {}, Parallel(1));
  for (std::size_t i = 0; i < EnumNames<planning::ViewPolicy>::value.size(); ++i) {
    ExploreOptions options;
    options.planner.policy = static_cast<planning::ViewPolicy>(i);
    options.max_scans = 60;
    const Exploration exploration = Explore(floor, cover, floor.T_map_start, options, 1);
    EXPECT_TRUE(exploration.ended) << EnumNames<planning::ViewPolicy>::value[i];
    EXPECT_GT(exploration.steps.back().covered, 0.97) << EnumNames<planning::ViewPolicy>::value[i];
  }
}

TEST(Explore, SeesAllOfAYardWiderThanItsRange) {
  Floor floor = CutFloor(drivers::ParsePlan(R"({"name": "yard", "unit": "m", "start": [20, 20],
    "area": 1600, "walls": [[0, 0, 40, 0], [40, 0, 40, 40], [40, 40, 0, 40], [0, 40, 0, 0]],
    "doors": [], "spaces": []})",
                                            "yard.json"),
                         1.5);
  const FloorCover cover = FindFloorCover(floor, ReachableFloor(floor, {.resolution = 0.5}), {},
                                          {.sample_spacing = 0.5}, Parallel(1));
  const Exploration exploration = Explore(floor, cover, floor.T_map_start, {}, 1);
  EXPECT_TRUE(exploration.ended);
  EXPECT_EQ(exploration.steps.front().covered, 0.0) << "15 m around the start there is nothing";
  EXPECT_GT(exploration.steps.back().covered, 0.99);
  floor.enclosed = false;
  EXPECT_LT(Explore(floor, cover, floor.T_map_start, {}, 1).steps.back().covered, 0.5);
}

TEST(Explore, RepeatsItselfAndDiffersBySeed) {
  const Floor floor = TwoRoomFloor();
  const FloorCover cover = FindFloorCover(floor, ReachableFloor(floor, {}), {}, {}, Parallel(1));
  const auto poses = [&](std::uint64_t seed) {
    std::vector<double> numbers;
    for (const ExploreStep& step : Explore(floor, cover, floor.T_map_start, {}, seed).steps) {
      numbers.insert(numbers.end(), {step.T_map_scan.translation.x(), step.T_map_scan.angle, step.path});
    }
    return numbers;
  };
  EXPECT_EQ(poses(3), poses(3));
  EXPECT_NE(poses(3), poses(4));
}

}  // namespace
}  // namespace ariadne::experiments
