#include "experiments/mission/next_drive.h"

#include <gtest/gtest.h>

#include "experiments/mission/clear_way.h"
#include "experiments/mission/way_back.h"
#include "slam/geometry/angles.h"

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

/// From a corner behind two posts that leave the robot no room, but that it came through; the trail is
/// empty without `came`.
std::optional<PlannedDrive> DriveOutOfACorner(bool came) {
  Surroundings around = RoomWithLine(6.0, 4.5);
  for (double y = 0.0; y <= 4.0; y += 0.03) {
    if (std::abs(y - 2.0) > 0.2) around.obstacles_map.emplace_back(8.0, y);
  }
  for (double x = came ? 2.0 : 9.0; x <= 9.0; x += 0.05) around.trail_map.push_back({0.0, {x, 2.0}});
  return PlanDriveTo(around, {0.0, {9.0, 2.0}}, {0.0, {2.0, 1.0}}, {}, 1);
}

TEST(PlanDrive, GoesBackTheWayItCameWhereThereIsNoRoom) {
  const auto drive = DriveOutOfACorner(true);
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->of_disc);
  ASSERT_GT(drive->retraced, 20U);
  for (std::size_t i = 0; i < drive->retraced; ++i)
    EXPECT_NEAR(drive->path_map[i].translation.y(), 2.0, 1e-9) << i;
  EXPECT_LT(drive->path_map[drive->retraced - 1].translation.x(), 7.6) << "past the posts";
  EXPECT_NEAR(drive->path_map.back().translation.x(), 2.0, 0.05);
}

/// Two gaps in a row, through which a disc gets from one to the other and the rectangle does not.
TEST(PlanDrive, GoesBackFarWhereTheRoomIsLarge) {
  Surroundings around = RoomWithLine(6.0, 4.5);
  for (double y = 0.0; y <= 4.0; y += 0.03) {
    if (std::abs(y - 2.0) > 0.42) around.obstacles_map.emplace_back(4.0, y);
    if (std::abs(y - 2.6) > 0.42) around.obstacles_map.emplace_back(4.7, y);
  }
  for (double x = 2.0; x <= 9.0; x += 0.05) around.trail_map.push_back({0.0, {x, 2.0}});
  MissionOptions hasty;
  hasty.path.max_iterations = 50;
  const auto drive = PlanDriveTo(around, {0.0, {9.0, 2.0}}, {0.0, {2.0, 1.0}}, hasty, 1);
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->of_disc);
  ASSERT_GT(drive->retraced, 0U);
  EXPECT_LT(drive->path_map[drive->retraced - 1].translation.x(), 4.6) << "past the first of them";
}

TEST(PlanDrive, FindsNoWayWhereItDoesNotKnowHowItCame) { EXPECT_FALSE(DriveOutOfACorner(false)); }

// A window that noise opens anew promises the same for ever.
TEST(PlanNextDrive, DoesNotScanTwiceFromOnePose) {
  Surroundings around = RoomWithLine(6.0, 4.5);
  around.areas[0][0].outer[1].seen = false;  // all of the right wall
  const Pose2 stand{0.0, {1.0, 2.0}};
  for (int i = 0; i < 5; ++i) {
    const auto drive = PlanNextDrive(around, stand, {}, {}, 1);
    ASSERT_TRUE(drive && drive->view);
    const Pose2 stop{drive->view->direction, drive->view->p_map};
    for (const Pose2& before : around.T_map_stops) {
      EXPECT_TRUE((before.translation - stop.translation).norm() >= 0.15 ||
                  std::abs(slam::WrapAngle(before.angle - stop.angle)) >= 0.1);
    }
    around.T_map_stops.push_back(stop);
  }
}

// A gap that a disc of the robot's half width passes and its rectangle does not.
TEST(PlanNextDrive, TriesTheWayOfADiscIntoARoomTwiceOnly) {
  Surroundings around = RoomWithLine(6.0, 4.5);
  around.areas[0][0].outer[1].seen = false;  // all of the right wall
  for (double y = 0.0; y <= 4.0; y += 0.03) {
    if (std::abs(y - 2.0) > 0.325) around.obstacles_map.emplace_back(5.0, y);
  }
  const Pose2 stand{0.0, {2.0, 2.0}};
  MissionOptions options;
  options.planner.view.gain.max_range = 3.0;  // from beyond the gap
  options.patience.targets = 1;
  const auto drive = PlanNextDrive(around, stand, {}, options, 1);
  ASSERT_TRUE(drive && drive->view);
  EXPECT_TRUE(drive->of_disc);
  EXPECT_GT(drive->view->p_map.x(), 5.0);
  std::vector<FailedTarget> failed{{{7.0, 2.0}, 1, true}};
  EXPECT_TRUE(PlanNextDrive(around, stand, failed, options, 1)) << "once more, from another side maybe";
  failed.push_back({{7.0, 3.0}, 1, true});
  EXPECT_FALSE(PlanNextDrive(around, stand, failed, options, 1));
}

TEST(PlanRetreat, GoesBackAsFarAsItIsTold) {
  std::vector<Pose2> trail;
  for (double x = 0.0; x < 8.0; x += 0.05) trail.push_back({0.0, {x, 1.0}});
  const PlannedDrive drive = PlanRetreat(trail, 3.0);
  EXPECT_FALSE(drive.view);
  EXPECT_EQ(drive.retraced, drive.path_map.size());
  EXPECT_EQ(drive.path_map.front().translation, trail.back().translation);
  EXPECT_NEAR(LengthOf(drive.path_map), 3.0, 0.06);
}

TEST(WayBack, LeavesOutTurnsToAndFroInPlace) {
  const std::vector<Pose2> driven{
      {0.0, {0.0, 0.0}}, {0.0, {0.1, 0.0}}, {-0.1, {0.1, 0.0}}, {0.04, {0.1, 0.0}}};
  const std::vector<Pose2> back = WayBack(driven, 10.0);
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back.front().angle, 0.04) << "where the robot is";
  EXPECT_EQ(back.back().translation.x(), 0.0);
}

/// Where the localization was corrected, the trail has a step that no robot can drive.
TEST(WayBack, LeavesOutStepsAside) {
  for (const double aside : {0.004, 0.03, 0.08}) {
    std::vector<Pose2> driven;
    for (double x = 0.0; x < 1.0; x += 0.04) driven.push_back({0.0, {x, 0.0}});
    for (double angle = 0.0; angle > -0.3; angle -= 0.05) driven.push_back({angle, {0.98, 0.0}});
    driven.push_back({-0.3, {0.985, aside}});
    const std::vector<Pose2> back = WayBack(driven, 10.0);
    EXPECT_LT(back.back().translation.x(), 0.1);
    for (std::size_t i = 1; i < back.size(); ++i) {
      const Vector2d step = back[i].translation - back[i - 1].translation;
      EXPECT_LT(std::abs(step.y()), 0.5 * step.norm() + 1e-9) << aside << ", " << i;
    }
    const auto turned = std::ranges::find_if(back, [](const Pose2& pose) { return pose.angle > -0.2; });
    EXPECT_LT((turned->translation - driven.back().translation).norm(), 1e-9) << "in place";
  }
}

/// Two rooms of 5 m x 4 m with a gap of 1.2 m between them that the map takes for closed; a robot that came
/// through it to the right one, and has seen all walls but one of the left.
Surroundings ShutIn(bool seen) {
  Surroundings around;
  planning::LabelledPolygon rooms;
  for (const Vector2d& corner : {Vector2d{0, 0},
                                 {5, 0},
                                 {5, 1.4},
                                 {5.1, 1.4},
                                 {5.1, 0},
                                 {10, 0},
                                 {10, 4},
                                 {5.1, 4},
                                 {5.1, 2.6},
                                 {5, 2.6},
                                 {5, 4},
                                 {0, 4}})
    rooms.outer.push_back({corner, true});
  rooms.outer[1].seen = seen;  // from (5, 0) to (5, 1.4)
  around.areas = {{rooms}};
  for (double y = 1.4; y <= 2.6; y += 0.03) around.obstacles_map.emplace_back(5.05, y);
  for (double x = 2.0; x <= 6.5; x += 0.05) around.trail_map.push_back({0.0, {x, 2.0}});
  return around;
}

TEST(PlanWayOut, GoesBackThroughWhatTheMapTakesForClosed) {
  Surroundings around = ShutIn(false);
  const Pose2 stand = around.trail_map.back();
  ASSERT_FALSE(PlanNextDrive(around, stand, {}, {}, 1)) << "nothing leads there";
  const auto drive = PlanWayOut(around, {}, {}, 1);
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->view);
  EXPECT_EQ(drive->retraced, drive->path_map.size());
  EXPECT_NEAR(drive->path_map.back().translation.x(), 3.5, 0.06);

  EXPECT_FALSE(PlanWayOut(ShutIn(true), {}, {}, 1)) << "nothing is worth it";
  around.trail_map.assign(1, stand);
  EXPECT_FALSE(PlanWayOut(around, {}, {}, 1)) << "it has come from nowhere";
}

TEST(WayBack, LeavesOutWhatWasDrivenToAndFro) {
  std::vector<Pose2> driven;
  for (const double x : {0.0, 0.1, 0.2, 0.3, 0.4, 0.3, 0.2, 0.3, 0.4, 0.5, 0.6})
    driven.push_back({0.0, {x, 0.0}});
  const std::vector<Pose2> all = WayBack(driven, 10.0), near = WayBack(driven, 0.25);
  ASSERT_EQ(all.size(), 7U);
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_NEAR(all[i].translation.x(), 0.6 - 0.1 * static_cast<double>(i), 1e-9);
  ASSERT_EQ(near.size(), 4U) << "up to the first one that is farther";
  EXPECT_TRUE(WayBack({}, 1.0).empty());
}

TEST(AddToTrail, KeepsTheWayWhateverTimeTheRobotStood) {
  std::vector<Pose2> driven;
  for (double x = 0.0; x < 20.0; x += 0.04) driven.push_back({0.0, {x, 1.0}});
  driven.insert(driven.end(), 100'000, Pose2{0.0, {20.0, 1.0}});
  driven.push_back({0.0, {20.005, 1.0}});
  std::vector<Pose2> trail;
  AddToTrail(driven, trail);
  EXPECT_EQ(trail.front().translation.x(), 0.0);
  EXPECT_EQ(trail.back().translation.x(), 20.005) << "where the robot is";
  EXPECT_LT(trail.size(), 510U);
  for (int i = 0; i < 100; ++i) AddToTrail(driven, trail);
  EXPECT_LE(trail.size(), 10'000U);
  EXPECT_EQ(trail.back().translation.x(), 20.005);
}

// What it does not see beside itself is not clear; its front corner must not sweep it all the same.
TEST(PlanDrive, TouchesNothingThatIsNotClearBeforeIt) {
  const Surroundings around = RoomWithLine(1.9, 1.2);
  const auto drive = DriveThrough(around);
  ASSERT_TRUE(drive);
  EXPECT_NEAR(drive->path_map.back().translation.x(), 9.0, 0.05);
  for (const Pose2& pose : drive->path_map) {
    for (const Vector2d& p_map : around.unclear_map)
      ASSERT_GT(control::GapTo({.margin = 0.04}, pose, p_map), -0.03);
  }
}

TEST(PlanDrive, TurnsWhereItStandsWhateverIsNotClearBesideIt) {
  Surroundings around = RoomWithLine(6.0, 4.5);
  for (double x = 0.6; x < 1.4; x += 0.03) around.unclear_map.emplace_back(x, 1.45);
  const auto drive = DriveThrough(around);
  ASSERT_TRUE(drive);
  EXPECT_FALSE(drive->leg_only);
  EXPECT_NEAR(LengthOf(drive->path_map), 8.0, 0.3);
}

TEST(ReachableGoals, AreThoseOnTheSameSideOfASlit) {
  const slam::Polygon2 room{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {0.0, 4.0}}, {}};
  const auto reached = [&](double slit) {
    std::vector<Vector2d> wall;
    for (double y = 0.0; y <= 4.0; y += 0.03) {
      if (std::abs(y - 2.0) > 0.5 * slit) wall.emplace_back(5.0, y);
    }
    const planning::FreeSpace space({&room, 1}, {}, wall);
    const std::vector<Pose2> goals{{0.0, {3.0, 3.0}}, {1.0, {8.0, 1.0}}, {0.0, {9.9, 2.0}}};
    return planning::ReachableGoals(space, {0.0, {1.0, 1.0}}, goals, {});
  };
  EXPECT_EQ(reached(0.9), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(reached(0.65), (std::vector<bool>{true, false, false}));
}

TEST(ClearPoses, EndBeforeWhatIsNotFree) {
  const slam::Polygon2 room{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {0.0, 4.0}}, {}};
  const planning::FreeSpace space({&room, 1});
  std::vector<Pose2> path;
  for (double x = 0.5; x < 11.0; x += 0.1) path.push_back({0.0, {x, 2.0}});
  const std::size_t clear = ClearPoses(path, space, {});
  ASSERT_LT(clear, path.size());
  EXPECT_NEAR(path[clear].translation.x(), 9.6, 0.11);
}

}  // namespace
}  // namespace ariadne::experiments
