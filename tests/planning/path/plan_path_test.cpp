#include "planning/path/plan_path.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>
#include <set>

#include "planning/path/curved_way.h"
#include "slam/geometry/angles.h"
#include "tests/planning/path/random_rooms.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

constexpr std::array kModels{PathModel::kGeometric, PathModel::kReedsShepp, PathModel::kDubins};

slam::Pose2 DrawStand(const PillarRoom& room, const FreeSpace& space, RandomStream& stream) {
  for (;;) {
    const Eigen::Vector2d p = DrawAround(room.room, stream);
    const slam::Pose2 pose{DrawUniform(stream, -3.14, 3.14), p};
    if (Footprint().IsFree(space, pose)) return pose;
  }
}

bool AreSame(const std::vector<slam::Pose2>& a, const std::vector<slam::Pose2>& b) {
  return std::ranges::equal(a, b, [](const slam::Pose2& x, const slam::Pose2& y) {
    return x.angle == y.angle && x.translation == y.translation;
  });
}

void ExpectDriveable(const PathResult& path, PathModel model) {
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    const slam::Pose2 step = path.poses[i - 1].Inverse() * path.poses[i];
    ASSERT_LE(step.translation.norm(), 0.05 + 1e-6);
    if (model == PathModel::kGeometric) continue;
    ASSERT_LE(std::abs(step.angle), std::abs(step.translation.x()) / 0.3 * 1.01 + 1e-4)
        << i << ": turns too tightly";
    ASSERT_LE(std::abs(step.translation.y()), 0.5 * 0.05 * 0.05 / 0.3 + 1e-4) << i << ": moves sideways";
    if (model == PathModel::kDubins) {
      ASSERT_GE(step.translation.x(), -1e-4) << i << ": moves backward";
    }
  }
}

TEST(PlanPath, IsFreeExactAndDriveable) {
  int found = 0, unreachable = 0, lost = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    for (const PathModel model : kModels) {
      const slam::Pose2 start = DrawStand(room, space, stream), goal = DrawStand(room, space, stream);
      PathOptions options;
      options.model = model;
      const PathResult path = PlanPath(space, start, goal, options, seed);
      found += path.status == PathStatus::kFound;
      unreachable += path.status == PathStatus::kUnreachable;
      lost += path.status == PathStatus::kNotFound;
      if (path.status != PathStatus::kFound) continue;
      EXPECT_TRUE(AreSame({path.poses.front(), path.poses.back()}, {start, goal}));
      EXPECT_GE(path.length, (goal.translation - start.translation).norm() - 1e-6);
      ExpectDriveable(path, model);
      for (const slam::Pose2& pose : path.poses) {
        EXPECT_TRUE(IsRectangleWithin(room.area, Footprint().CornersAt(pose)))
            << seed << " " << NameOf(model);
      }
    }
  }
  EXPECT_EQ(found, 18) << unreachable << " unreachable, " << lost << " not found";
}

struct PathQuery {
  slam::Pose2 start, goal;
};

std::vector<PathQuery> DrawQueries(const PillarRoom& room, const FreeSpace& space, int count) {
  RandomStream stream = NamedStream(1, "test");
  std::vector<PathQuery> queries;
  for (int i = 0; i < count; ++i) {
    const slam::Pose2 start = DrawStand(room, space, stream);
    queries.push_back({start, DrawStand(room, space, stream)});
  }
  return queries;
}

/// How many places of 5 cm, with headings of 5 deg, a robot can reach that only goes forward: in breadth,
/// with the exact rectangle and its margin, and what a planner may leave of that.
std::size_t ForwardPlaces(const PillarRoom& room, const slam::Pose2& start, std::size_t most) {
  FootprintOptions wide;
  wide.length += 2.0 * 0.065;
  wide.width += 2.0 * 0.065;
  const Footprint footprint(wide);
  std::set<std::array<long, 3>> places;
  std::vector<slam::Pose2> poses{start};
  const auto is_new = [&](const slam::Pose2& pose) {
    return places
        .insert({std::lround(pose.translation.x() / 0.05), std::lround(pose.translation.y() / 0.05),
                 std::lround(slam::DegFromRad(pose.angle) / 5.0)})
        .second;
  };
  for (std::size_t i = 0; i < poses.size() && poses.size() < most; ++i) {
    for (const int turn : {0, 1, -1}) {
      const CurvedWay step(poses[i], 0.3, {{turn, 0.08 / 0.3}});
      const bool is_free = std::ranges::all_of(step.Sampled(0.03), [&](const slam::Pose2& pose) {
        return IsRectangleWithin(room.area, footprint.CornersAt(pose));
      });
      const slam::Pose2 next = step.At(1.0);
      if (is_free && is_new(next)) poses.push_back(next);
    }
  }
  return poses.size();
}

/// RRT-Connect misses ways forward that begin with a loop; and what cannot be left forward is no miss.
TEST(PlanPath, FindsWaysForwardWhereThereAreAny) {
  const PillarRoom room = RandomPillarRoom(1);
  const FreeSpace space(std::span(&room.area, 1));
  const std::vector<PathQuery> queries = DrawQueries(room, space, 53);
  PathOptions options;
  options.model = PathModel::kDubins;
  for (const std::size_t i : {15U, 52U}) {
    const PathResult path = PlanPath(space, queries[i].start, queries[i].goal, options, i);
    ASSERT_EQ(path.status, PathStatus::kFound) << i;
    EXPECT_TRUE(AreSame({path.poses.front(), path.poses.back()}, {queries[i].start, queries[i].goal}));
    ExpectDriveable(path, options.model);
    for (const slam::Pose2& pose : path.poses)
      EXPECT_TRUE(IsRectangleWithin(room.area, Footprint().CornersAt(pose))) << i;
  }
  for (const std::size_t i : {11U, 22U, 32U, 39U}) {
    const PathResult path = PlanPath(space, queries[i].start, queries[i].goal, options, i);
    EXPECT_EQ(path.status, PathStatus::kNotFound) << i;
    EXPECT_LT(ForwardPlaces(room, queries[i].start, 20000), 1000U) << i << ": the robot is not shut in";
    options.model = PathModel::kReedsShepp;
    EXPECT_EQ(PlanPath(space, queries[i].start, queries[i].goal, options, i).status, PathStatus::kFound);
    options.model = PathModel::kDubins;
  }
  EXPECT_EQ(ForwardPlaces(room, queries[15].start, 20000), 20000U) << "what is counted tells nothing";
}

/// Two rooms with a door in the wall between.
slam::Polygon2 TwoRooms(double door) {
  return {{{0.0, 0.0},
           {4.0, 0.0},
           {4.0, 2.0},
           {4.2, 2.0},
           {4.2, 0.0},
           {8.0, 0.0},
           {8.0, 5.0},
           {4.2, 5.0},
           {4.2, 2.0 + door},
           {4.0, 2.0 + door},
           {4.0, 5.0},
           {0.0, 5.0}},
          {}};
}

TEST(PlanPath, IsRepeatableWhateverRanBefore) {
  const std::array area{TwoRooms(1.2)};
  const FreeSpace space(area);
  const slam::Pose2 start{2.0, {1.5, 3.5}}, goal{-1.0, {6.5, 1.0}};
  int different = 0;
  for (const PathModel model : kModels) {
    PathOptions options;
    options.model = model;
    options.guided = 0.2;
    const PathResult first = PlanPath(space, start, goal, options, 1);
    const PathResult other = PlanPath(space, start, goal, options, 2);
    const PathResult again = PlanPath(space, start, goal, options, 1);
    EXPECT_TRUE(AreSame(first.poses, again.poses)) << NameOf(model);
    EXPECT_EQ(first.length, again.length);
    EXPECT_EQ(first.iterations, again.iterations);
    different += !AreSame(first.poses, other.poses);
  }
  EXPECT_GT(different, 0) << "does not follow the seed";
}

TEST(PlanPath, SaysNothing) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 6.0, 5.0), {}}};
  const FreeSpace space(area);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(PlanPath(space, {0.0, {1.0, 1.0}}, {1.0, {5.0, 4.0}}, {}, 1).status, PathStatus::kFound);
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

TEST(PlanPath, FindsDoorsAndSaysWhereThereIsNoWay) {
  const slam::Pose2 start{2.0, {1.5, 3.5}}, goal{-1.0, {6.5, 1.5}};
  for (const PathModel model : kModels) {
    PathOptions options;
    options.model = model;
    const std::array open{TwoRooms(0.8)}, narrow{TwoRooms(0.6)}, closed{TwoRooms(0.0)};
    const PathResult path = PlanPath(FreeSpace(open), start, goal, options, 1);
    EXPECT_EQ(path.status, PathStatus::kFound) << NameOf(model);
    for (const slam::Pose2& pose : path.poses) {
      EXPECT_TRUE(IsRectangleWithin(open[0], Footprint().CornersAt(pose))) << NameOf(model);
    }
    options.max_iterations = 30;
    const PathResult none = PlanPath(FreeSpace(narrow), start, goal, options, 1);
    EXPECT_EQ(none.status, PathStatus::kNotFound);
    EXPECT_TRUE(none.poses.empty());
    EXPECT_EQ(none.iterations, 30);
    EXPECT_EQ(PlanPath(FreeSpace(closed), start, goal, options, 1).status, PathStatus::kUnreachable);
  }
}

/// Two rooms that a bent passage of 0.75 m joins, which a disc takes and the robot cannot turn in, and, if
/// it is there, a wide way around.
slam::Polygon2 RoomsWithABend(bool way_around) {
  slam::Polygon2 area{Box(0.0, 0.0, 12.0, 10.0), {}};
  constexpr double y = 8.0;  // where what stands between the rooms ends
  area.outer = {{0.0, 0.0}, {4.0, 0.0},  {4.0, 2.0},   {6.0, 2.0},
                {6.0, 0.0}, {12.0, 0.0}, {12.0, 10.0}, {0.0, 10.0}};
  area.holes = {{{4.0, 2.75}, {4.0, y}, {8.0, y}, {8.0, 1.25}, {6.75, 1.25}, {6.75, 2.75}}};
  if (!way_around) {
    area.outer = {{0.0, 0.0},   {4.0, 0.0},   {4.0, 2.0},  {6.0, 2.0},  {6.0, 0.0},
                  {12.0, 0.0},  {12.0, 10.0}, {8.0, 10.0}, {8.0, 1.25}, {6.75, 1.25},
                  {6.75, 2.75}, {4.0, 2.75},  {4.0, 10.0}, {0.0, 10.0}};
    area.holes.clear();
  }
  return area;
}

TEST(PlanPath, GoesAroundWhereTheShortestWayOfADiscIsTooTightForTheRectangle) {
  const std::array around{RoomsWithABend(true)}, closed{RoomsWithABend(false)};
  const slam::Pose2 start{0.0, {2.0, 2.4}}, goal{0.0, {10.0, 2.4}};
  PathOptions options;
  options.max_iterations = 400;  // too few to find the way around by chance
  for (const PathModel model : {PathModel::kGeometric, PathModel::kReedsShepp}) {
    options.model = model;
    const PathResult path = PlanPath(FreeSpace(around), start, goal, options, 1);
    EXPECT_EQ(path.status, PathStatus::kFound) << NameOf(model);
    EXPECT_GT(path.length, 14.0);
    for (const slam::Pose2& pose : path.poses) {
      ASSERT_TRUE(IsRectangleWithin(around[0], Footprint().CornersAt(pose))) << NameOf(model);
    }
    EXPECT_EQ(PlanPath(FreeSpace(closed), start, goal, options, 1).status, PathStatus::kNotFound);
  }
}

TEST(PlanPath, EndsWhereItBegins) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 6.0, 5.0), {}}};
  const FreeSpace space(area);
  const slam::Pose2 start{std::numbers::pi, {3.0, 2.0}};
  for (const PathModel model : kModels) {
    PathOptions options;
    options.model = model;
    const PathResult none = PlanPath(space, start, start, options, 1);
    EXPECT_EQ(none.status, PathStatus::kFound);
    EXPECT_EQ(none.length, 0.0);
    // Half a turn, with both ends at the yaw that OMPL has no place for, and steps of a few micrometres.
    for (const slam::Pose2& to : {slam::Pose2{0.0, {3.0, 2.0}}, slam::Pose2{-std::numbers::pi, {3.5, 2.0}},
                                  slam::Pose2{std::numbers::pi, {3.0, 2.000003}}}) {
      const PathResult path = PlanPath(space, start, to, options, 1);
      EXPECT_EQ(path.status, PathStatus::kFound);
      EXPECT_EQ(path.poses.back().translation, to.translation);
      ExpectDriveable(path, model);
    }
  }
}

TEST(PlanPath, SaysWhoseFaultItIs) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 6.0, 5.0), {}}};
  const FreeSpace space(area);
  const slam::Pose2 good{0.0, {3.0, 2.0}}, bad{0.0, {3.0, 0.32}}, outside{0.0, {-3.0, 2.0}};
  EXPECT_EQ(PlanPath(space, bad, good, {}, 1).status, PathStatus::kStartNotFree);
  EXPECT_EQ(PlanPath(space, good, bad, {}, 1).status, PathStatus::kGoalNotFree);
  EXPECT_EQ(PlanPath(space, good, outside, {}, 1).status, PathStatus::kGoalNotFree);
  EXPECT_EQ(PlanPath(FreeSpace({}), good, good, {}, 1).status, PathStatus::kStartNotFree);
  EXPECT_EQ(ErrorOf([&] {
              PlanPath(space, good, {0.0, {std::nan(""), 1.0}}, {}, 1);
            }),
            "the path's goal (nan, 1, 0 rad) is no pose");
  PathOptions options;
  options.turning_radius = 0.0;
  EXPECT_NE(ErrorOf([&] { PlanPath(space, good, good, options, 1); }).find("path.turning_radius"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
