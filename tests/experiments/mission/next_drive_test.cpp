#include "experiments/mission/next_drive.h"

#include <gtest/gtest.h>

#include "experiments/mission/clear_way.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;
using slam::Pose2;

/// A room of 10 m x 4 m, and what is not clear in it: a line across at x, from one wall to `open` before
/// the other.
Surroundings RoomWithLine(double x, double open) {
  Surroundings around;
  planning::LabelledPolygon room;
  room.outer = {{{0.0, 0.0}, true}, {{10.0, 0.0}, true}, {{10.0, 4.0}, true}, {{0.0, 4.0}, true}};
  around.areas = {{room}};
  for (double y = 0.0; y <= 4.0 - open; y += 0.03) around.unclear_map.emplace_back(x, y);
  return around;
}

std::optional<PlannedDrive> DriveThrough(const Surroundings& around, const MissionOptions& options = {}) {
  return PlanDriveTo(around, {0.0, {1.0, 1.0}}, {0.0, {9.0, 1.0}}, options, 1);
}

double FarthestAt(const PlannedDrive& drive) {
  double farthest = 0.0;
  for (const Pose2& pose : drive.path_map) farthest = std::max(farthest, pose.translation.x());
  return farthest;
}

TEST(PlanDrive, GoesToTheGoalWhereAllIsClear) {
  const auto drive = DriveThrough(RoomWithLine(6.0, 4.5));
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->leg_only);
  EXPECT_NEAR(drive->path_map.back().translation.x(), 9.0, 0.05);
}

TEST(PlanDrive, GoesRoundWhatIsNotClear) {
  const Surroundings around = RoomWithLine(6.0, 1.2);
  const auto drive = DriveThrough(around);
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->leg_only);
  EXPECT_NEAR(drive->path_map.back().translation.x(), 9.0, 0.05);
  for (const Pose2& pose : drive->path_map) {
    for (const Vector2d& p_map : around.unclear_map)
      ASSERT_GT(control::GapTo({.margin = 0.04}, pose, p_map), -0.03);
  }
}

TEST(PlanDrive, EndsALegBeforeWhatIsNotClear) {
  const auto drive = DriveThrough(RoomWithLine(6.0, 0.0));
  ASSERT_TRUE(drive);
  EXPECT_TRUE(drive->leg_only);
  EXPECT_LT(FarthestAt(*drive), 5.6);
  EXPECT_GT(FarthestAt(*drive), 5.0);
}

TEST(PlanDrive, GoesOnAllTheSameWhereTheLegIsNotWorthAScan) {
  const auto drive = DriveThrough(RoomWithLine(2.4, 0.0));
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->leg_only);
  EXPECT_NEAR(drive->path_map.back().translation.x(), 9.0, 0.05);
}

TEST(PlanDrive, TakesAllForClearWithoutGaps) {
  MissionOptions options;
  options.clear.gap = 0.0;
  const auto drive = DriveThrough(RoomWithLine(6.0, 1.2), options);
  ASSERT_TRUE(drive);
  EXPECT_NEAR(LengthOf(drive->path_map), 8.0, 0.1);
}

TEST(ClearPoses, MayBeginInWhatIsNotFree) {
  const slam::Polygon2 room{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {0.0, 4.0}}, {}};
  const planning::FreeSpace space({&room, 1});
  std::vector<Pose2> path;
  for (double x = 0.3; x < 11.0; x += 0.1) path.push_back({0.0, {x, 2.0}});
  const std::size_t clear = ClearPoses(path, space, {});
  ASSERT_LT(clear, path.size());
  EXPECT_NEAR(path[clear].translation.x(), 9.6, 0.11);
}

}  // namespace
}  // namespace ariadne::experiments
