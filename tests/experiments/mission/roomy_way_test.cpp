#include "experiments/mission/roomy_way.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/mission/clear_way.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kStraight = 8.0;  // from start to goal [m]

/// A hall of 10 m x `width`, and what stands in it.
planning::FreeSpace Hall(double width, const std::vector<Eigen::Vector2d>& things_map) {
  const slam::Polygon2 hall{{{0.0, 0.0}, {10.0, 0.0}, {10.0, width}, {0.0, width}}, {}};
  return planning::FreeSpace({&hall, 1}, {}, things_map);
}

planning::PathOptions WithMarginOf(double margin) {
  planning::PathOptions options;
  options.footprint.margin = margin;
  return options;
}

/// Straight ahead.
std::vector<Pose2> StraightPath(double y) {
  std::vector<Pose2> path;
  for (int i = 0; i <= 160; ++i) path.push_back({0.0, {1.0 + kStraight * i / 160.0, y}});
  return path;
}

bool Keeps(double margin, const std::vector<Pose2>& path, const planning::FreeSpace& space) {
  const planning::Footprint robot(WithMarginOf(margin).footprint);
  return std::ranges::all_of(path, [&](const Pose2& pose) { return robot.IsFree(space, pose); });
}

/// No step is longer than those of a path.
void ExpectWhole(const std::vector<Pose2>& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    ASSERT_LT((path[i].translation - path[i - 1].translation).norm(), 0.12) << i;
}

TEST(WithRoom, KeepsOffWhatStandsBesideThePath) {
  const planning::FreeSpace space = Hall(4.0, {{5.0, 1.55}, {7.5, 2.42}});
  const std::vector<Pose2> path = StraightPath(2.0);
  ASSERT_TRUE(Keeps(0.08, path, space));
  ASSERT_FALSE(Keeps(0.2, path, space));
  const std::vector<Pose2> roomy = WithRoom(space, path, WithMarginOf(0.08), {}, 1);
  EXPECT_TRUE(Keeps(0.2, roomy, space));
  EXPECT_EQ(roomy.front().translation, path.front().translation);
  EXPECT_EQ(roomy.back().translation, path.back().translation);
  EXPECT_LT(LengthOf(roomy), 1.05 * kStraight);
  ExpectWhole(roomy);
}

TEST(WithRoom, GoesThroughANarrowPlaceAllTheSame) {
  const planning::FreeSpace space =
      Hall(4.0, {{5.0, 0.3}, {5.0, 0.9}, {5.0, 1.6}, {5.0, 2.4}, {5.0, 3.1}, {5.0, 3.7}});
  const std::vector<Pose2> path = StraightPath(2.0),
                           roomy = WithRoom(space, path, WithMarginOf(0.08), {}, 1);
  EXPECT_TRUE(Keeps(0.08, roomy, space));
  EXPECT_NEAR(LengthOf(roomy), kStraight, 0.05);
  EXPECT_EQ(roomy.back().translation, path.back().translation);
  ExpectWhole(roomy);
}

TEST(WithRoom, TakesHalfOfItWhereThereIsNoMore) {
  const planning::FreeSpace space = Hall(0.95, {{5.0, 0.1}});
  const std::vector<Pose2> path = StraightPath(0.475);
  ASSERT_FALSE(Keeps(0.09, path, space));
  const std::vector<Pose2> roomy = WithRoom(space, path, WithMarginOf(0.04), {.margin = 0.16}, 1);
  EXPECT_TRUE(Keeps(0.1, roomy, space));
}

TEST(WithRoom, MakesNoLongDetour) {
  std::vector<Eigen::Vector2d> wall;  // with a gap that is just wide enough, and one that is wider, far off
  for (double y = 0.0; y < 12.0; y += 0.05) {
    if (std::abs(y - 2.0) > 0.42 && std::abs(y - 10.0) > 1.0) wall.emplace_back(5.0, y);
  }
  const planning::FreeSpace space = Hall(12.0, wall);
  const std::vector<Pose2> path = StraightPath(2.0);
  ASSERT_TRUE(Keeps(0.08, path, space));
  EXPECT_NEAR(LengthOf(WithRoom(space, path, WithMarginOf(0.08), {}, 1)), kStraight, 0.05);
  EXPECT_GT(LengthOf(WithRoom(space, path, WithMarginOf(0.08), {.detour = 10.0}, 1)), 2.0 * kStraight);
}

TEST(WithRoom, LeavesEndsAloneThatHaveNone) {
  const planning::FreeSpace space = Hall(4.0, {{1.0, 1.58}, {9.0, 1.58}, {5.0, 1.58}});
  const std::vector<Pose2> path = StraightPath(2.0),
                           roomy = WithRoom(space, path, WithMarginOf(0.08), {}, 1);
  EXPECT_TRUE(Keeps(0.08, roomy, space));
  EXPECT_EQ(roomy.front().translation, path.front().translation);
  EXPECT_EQ(roomy.back().translation, path.back().translation);
  const planning::Footprint robot(WithMarginOf(0.2).footprint);
  for (const Pose2& pose : roomy) {
    EXPECT_TRUE(std::abs(pose.translation.x() - 5.0) > 2.0 || robot.IsFree(space, pose));
  }
}

TEST(WithRoom, IsOffWithoutAMargin) {
  const planning::FreeSpace space = Hall(4.0, {{5.0, 1.55}});
  const std::vector<Pose2> path = StraightPath(2.0),
                           same = WithRoom(space, path, WithMarginOf(0.08), {.margin = 0.0}, 1);
  ASSERT_EQ(same.size(), path.size());
  EXPECT_TRUE(WithRoom(space, {}, WithMarginOf(0.08), {}, 1).empty());
}

}  // namespace
}  // namespace ariadne::experiments
