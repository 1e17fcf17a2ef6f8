#include "planning/view/view_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "planning/path/geodesic.h"
#include "planning/view/view_policy.h"
#include "slam/geometry/angles.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;

/// Two rooms of 6 x 4 m side by side, with a door of 1 m between them, and open to the right: there the
/// boundary is unseen.
std::vector<LabelledPolygon> TwoRooms() {
  const LabelledRing outer{{{0.0, 0.0}, true},  {{6.0, 0.0}, true}, {{6.0, 1.5}, true},
                           {{6.2, 1.5}, true},  {{6.2, 0.0}, true}, {{12.0, 0.0}, false},
                           {{12.0, 4.0}, true}, {{6.2, 4.0}, true}, {{6.2, 2.5}, true},
                           {{6.0, 2.5}, true},  {{6.0, 4.0}, true}, {{0.0, 4.0}, true}};
  return {{outer, {}}};
}

const slam::Pose2 kInTheLeftRoom{0.0, {2.0, 2.0}};

std::vector<LabelledPolygon> MovedBy(const slam::Pose2& T_a_b, std::vector<LabelledPolygon> area) {
  for (LabelledPolygon& polygon : area) {
    for (LabelledCorner& corner : polygon.outer) corner.p_map = T_a_b * corner.p_map;
  }
  return area;
}

ViewPlannerOptions OfPolicy(ViewPolicy policy) {
  ViewPlannerOptions options;
  options.policy = policy;
  return options;
}

TEST(ViewPlanner, KeepsRoomAroundItsViews) {
  ViewPlannerOptions options;
  options.view_clearance = 1.2;
  const ViewPlan plan = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  ASSERT_EQ(plan.status, NextViewStatus::kFound);
  for (const View& view : plan.views) {
    EXPECT_GT(view.p_map.y(), 1.19);
    EXPECT_LT(view.p_map.y(), 2.81);
  }
  options.view_clearance = 2.5;  // no room of 4 m has it
  EXPECT_EQ(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).status, NextViewStatus::kNoCandidates);
}

TEST(ViewPlanner, PassesOverWhatIsTooNarrow) {
  ViewPlannerOptions options;
  options.min_opening = 3.9;
  EXPECT_EQ(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).status, NextViewStatus::kFound);
  options.min_opening = 4.1;  // than the open side
  EXPECT_EQ(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).status, NextViewStatus::kNoGain);
}

TEST(ViewPlanner, GoesWhereSomethingIsUnseen) {
  for (const auto policy :
       {ViewPolicy::kExponential, ViewPolicy::kGain, ViewPolicy::kRandom, ViewPolicy::kNearestFrontier,
        ViewPolicy::kPotentialArea, ViewPolicy::kTwoSteps}) {
    SCOPED_TRACE(EnumNames<ViewPolicy>::value[static_cast<std::size_t>(policy)]);
    const ViewPlan plan = PlanNextView(TwoRooms(), kInTheLeftRoom, OfPolicy(policy), 1);
    ASSERT_EQ(plan.status, NextViewStatus::kFound);
    const View& view = plan.views[*plan.chosen];
    EXPECT_GE(view.gain, 5);
    EXPECT_LT(std::abs(slam::WrapAngle(view.direction)), 1.6) << "towards the open side";
    ASSERT_GE(plan.path_map.size(), 2u);
    EXPECT_EQ(plan.path_map.front(), kInTheLeftRoom.translation);
    EXPECT_EQ(plan.path_map.back(), view.p_map);
    EXPECT_LE(LengthOf(plan.path_map), view.distance + 1e-9);
  }
}

TEST(ViewPlanner, MeasuresWaysAsItIsTold) {
  ViewPlannerOptions options;
  options.refined = 0;  // the same places, whichever is chosen
  const auto distances = [&] {
    std::vector<double> values;
    for (const View& view : PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).views) {
      values.push_back(view.distance);
    }
    return values;
  };
  const std::vector<double> geodesic = distances();
  options.way = WayLength::kStraight;
  const std::vector<double> straight = distances();
  options.way = WayLength::kRoadmap;
  const std::vector<double> roadmap = distances();
  ASSERT_EQ(geodesic.size(), 200u);
  for (std::size_t i = 0; i < geodesic.size(); ++i) {
    EXPECT_GE(geodesic[i], straight[i] - 1e-9);
    EXPECT_GE(roadmap[i], straight[i] - 1e-9);
    EXPECT_LT(geodesic[i], 1.1 * roadmap[i] + 0.5) << "the raster's error and the roadmap's detours";
  }
  const ViewPlan by_cost =
      PlanNextView(TwoRooms(), kInTheLeftRoom, {}, 1, {},
                   [](std::span<const Vector2d> path, const View&) { return path.back().x(); });
  for (const View& view : by_cost.views) EXPECT_EQ(view.distance, view.p_map.x());
}

TEST(ViewPlanner, OnlyJudgesPlacesWithRoomForTheRobot) {
  ViewPlannerOptions options;
  options.robot_radius = 0.45;  // the door is 1 m wide
  EXPECT_EQ(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).status, NextViewStatus::kFound);
  options.robot_radius = 0.6;
  for (const View& view : PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).views) {
    EXPECT_LT(view.p_map.x(), 5.7) << "the robot does not pass the door";
    EXPECT_GT(view.p_map.y(), 0.6 - 1e-3);
  }
}

TEST(ViewPlanner, TakesASecondLookBeforeItEnds) {
  // Only the last 30 cm of a long niche are unseen: no candidate of ten looks into it.
  const LabelledRing outer{{{0.0, 0.0}, true},  {{6.0, 0.0}, true},   {{6.0, 0.7}, true},
                           {{14.0, 0.7}, true}, {{14.0, 1.7}, false}, {{13.3, 1.7}, true},
                           {{6.0, 1.7}, true},  {{6.0, 4.0}, true},   {{0.0, 4.0}, true}};
  ViewPlannerOptions options;
  options.candidates.count = 3;
  options.view.min_gain = 40;
  const ViewPlan second =
      PlanNextView(std::vector<LabelledPolygon>{{outer, {}}}, kInTheLeftRoom, options, 1);
  ASSERT_EQ(second.status, NextViewStatus::kFound);
  EXPECT_TRUE(second.second_look);
  EXPECT_GT(second.views[*second.chosen].p_map.x(), 12.0);
  options.second_look = 0;
  EXPECT_EQ(PlanNextView(std::vector<LabelledPolygon>{{outer, {}}}, kInTheLeftRoom, options, 1).status,
            NextViewStatus::kNoGain);
}

TEST(ViewPlanner, LooksAsideOfAnEdgeAcrossACorridor) {
  // A corridor of 0.84 m, known up to a slanted edge: straight before that there is only wall.
  const LabelledRing corridor{{{0.0, 0.0}, true},  {{16.9, 0.0}, false}, {{12.0, 0.84}, true},
                              {{6.0, 0.84}, true}, {{6.0, 9.0}, true},   {{0.0, 9.0}, true}};
  ViewPlannerOptions options;
  options.candidates.count = 1;  // the corridor is a tenth of all
  options.refined = 0;
  options.view.min_gain = 20;
  const ViewPlan plan =
      PlanNextView(std::vector<LabelledPolygon>{{corridor, {}}}, {0.0, {2.0, 5.0}}, options, 1);
  ASSERT_EQ(plan.status, NextViewStatus::kFound);
  EXPECT_TRUE(plan.second_look);
  EXPECT_GT(plan.views[*plan.chosen].p_map.x(), 8.0) << "in the corridor";
}

TEST(ViewPlanner, EndsWhereAllIsSeen) {
  std::vector<LabelledPolygon> area = TwoRooms();
  for (LabelledCorner& corner : area[0].outer) corner.seen = true;
  EXPECT_EQ(PlanNextView(area, kInTheLeftRoom, {}, 1).status, NextViewStatus::kNoGain);
  EXPECT_EQ(PlanNextView(area, {0.0, {50.0, 50.0}}, {}, 1).status, NextViewStatus::kNoCandidates)
      << "not in the area";
  EXPECT_EQ(PlanNextView({}, kInTheLeftRoom, {}, 1).status, NextViewStatus::kNoCandidates);
}

TEST(ViewPlanner, LooksInVainOnlyFromEverNearer) {
  std::vector<slam::Pose2> scans{{0.0, {11.4, 0.5}}, {0.0, {11.4, 2.0}}, {0.0, {11.4, 3.5}}};
  EXPECT_EQ(PlanNextView(TwoRooms(), scans[0], {}, 1, scans).status, NextViewStatus::kNoGain);
  scans = {{std::numbers::pi, {11.4, 2.0}}};  // looks the other way
  EXPECT_EQ(PlanNextView(TwoRooms(), scans[0], {}, 1, scans).status, NextViewStatus::kFound);
  scans[0] = {0.0, {6.5, 2.0}};
  const ViewPlan nearer = PlanNextView(TwoRooms(), scans[0], {}, 1, scans);
  ASSERT_TRUE(nearer.chosen);
  EXPECT_GT(nearer.views[*nearer.chosen].p_map.x(), 9.0) << "half of 5.5 m before the open side";
}

TEST(ViewPlanner, TurnsAboutBeforeAWall) {
  // All that a robot knows that looks at a wall 40 cm before it: no room to go anywhere.
  const LabelledRing strip{
      {{0.0, -1.0}, false}, {{0.4, -1.0}, true}, {{0.4, 1.0}, false}, {{0.0, 1.0}, false}};
  const std::vector<LabelledPolygon> known{{strip, {}}};
  const std::vector<slam::Pose2> one{{0.0, {0.0, 0.0}}}, both{{0.0, {0.0, 0.0}}, {3.1, {0.0, 0.0}}};
  const ViewPlan about = PlanNextView(known, one[0], {}, 1, one);
  ASSERT_EQ(about.status, NextViewStatus::kFound);
  EXPECT_NEAR(std::abs(about.views[*about.chosen].direction), std::numbers::pi, 1e-12);
  EXPECT_EQ(LengthOf(about.path_map), 0.0);
  EXPECT_EQ(PlanNextView(known, one[0], {}, 1, both).status, NextViewStatus::kNoCandidates);
}

TEST(ViewPlanner, TurnsToEachSideWithANarrowView) {
  const LabelledRing wedge{{{0.0, 0.0}, false}, {{0.4, -0.4}, true}, {{0.4, 0.4}, false}};
  const std::vector<LabelledPolygon> known{{wedge, {}}};
  ViewPlannerOptions options;
  options.view.gain.field_of_view = 90.0;
  std::vector<slam::Pose2> scans{{0.3, {0.0, 0.0}}};
  std::vector<double> turns;
  for (int k = 0; k < 3; ++k) {
    const ViewPlan plan = PlanNextView(known, scans.back(), options, 1, scans);
    ASSERT_TRUE(plan.chosen);
    scans.push_back({plan.views[*plan.chosen].direction, {0.0, 0.0}});
    turns.push_back(slam::WrapAngle(scans.back().angle - 0.3));
  }
  constexpr double kHalfTurn = std::numbers::pi;
  EXPECT_NEAR(std::abs(turns[0]), kHalfTurn, 1e-9);
  EXPECT_NEAR(std::abs(turns[1]), 0.5 * kHalfTurn, 1e-9);
  EXPECT_NEAR(turns[2], -turns[1], 1e-9);
  EXPECT_EQ(PlanNextView(known, scans.back(), options, 1, scans).status, NextViewStatus::kNoCandidates);
  options.view.gain.field_of_view = 360.0;
  EXPECT_EQ(PlanNextView(known, scans[0], options, 1, std::span(scans).first(1)).status,
            NextViewStatus::kNoCandidates);
}

TEST(ViewPlanner, LeavesSmallGainsForLater) {
  const View near{.p_map = {1.0, 0.0}, .gain = 6, .area = 2.0, .distance = 1.0};
  const View far{.p_map = {15.0, 0.0}, .gain = 60, .area = 8.0, .distance = 15.0};
  const std::vector<View> views{near, far};
  const ViewChoice choice{views, {0, 1}, {}, {}};
  ViewPlannerOptions options;
  options.least_share = 0.26;
  EXPECT_EQ(ChooseView(choice, options, 1), 1u) << "a quarter of the largest gain waits";
  options.least_share = 0.25;
  EXPECT_EQ(ChooseView(choice, options, 1), 0u) << "2 exp(-0.1) > 8 exp(-1.5)";
}

TEST(ViewPlanner, LooksAgainAroundTheChosenOne) {
  ViewPlannerOptions options;
  const ViewPlan refined = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  options.refined = 0;
  const ViewPlan plain = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  ASSERT_TRUE(plain.chosen && refined.chosen);
  EXPECT_GT(refined.views.size(), plain.views.size());
  EXPECT_GE(refined.views[*refined.chosen].value, plain.views[*plain.chosen].value);
  for (std::size_t i = plain.views.size(); i < refined.views.size(); ++i) {
    EXPECT_LE((refined.views[i].p_map - plain.views[*plain.chosen].p_map).norm(),
              options.refine_radius + 1e-9);
  }
}

TEST(ViewPlanner, RefusesViewsWithoutOverlap) {
  ViewPlannerOptions options;
  options.min_overlap = 0.4;
  const ViewPlan plan = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  ASSERT_TRUE(plan.chosen);
  EXPECT_GE(plan.views[*plan.chosen].overlap, 0.4);
  options.min_overlap = 1.0;
  EXPECT_EQ(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1).status, NextViewStatus::kNoGain);
}

/// Straight at the unseen side there is no overlap; a place with a direction that has it must not be lost.
TEST(ViewPlanner, LooksAsideToHaveOverlap) {
  ViewPlannerOptions options;
  options.view.min_gain = 1;
  options.refined = 0;
  const ViewPlan free = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  options.min_overlap = 0.9;
  const ViewPlan plan = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  ASSERT_TRUE(free.chosen && plan.chosen);
  EXPECT_LT(free.views[*free.chosen].overlap, 0.9);
  EXPECT_GE(plan.views[*plan.chosen].overlap, 0.9);
  ASSERT_EQ(plan.views.size(), free.views.size());
  int turned = 0;
  for (std::size_t i = 0; i < plan.views.size(); ++i) {
    if (free.views[i].overlap >= 0.9) {
      EXPECT_EQ(plan.views[i].direction, free.views[i].direction);
    } else if (plan.views[i].overlap >= 0.9 && plan.views[i].gain >= 1) {
      ++turned;
    }
  }
  EXPECT_GT(turned, 20);
}

TEST(ViewPlanner, OfThePaperStaysNear) {
  const ViewPlan paper = PlanNextView(TwoRooms(), kInTheLeftRoom, PaperViewPlannerOptions(), 1);
  const ViewPlan calibrated = PlanNextView(TwoRooms(), kInTheLeftRoom, {}, 1);
  ASSERT_TRUE(paper.chosen && calibrated.chosen);
  EXPECT_LT(paper.views[*paper.chosen].distance, 1.0);
  EXPECT_GT(calibrated.views[*calibrated.chosen].distance, 1.5);
}

/// All numbers of a plan, to be compared bit by bit.
std::vector<double> NumbersOf(const ViewPlan& plan) {
  std::vector<double> numbers{plan.chosen ? static_cast<double>(*plan.chosen) : -1.0};
  for (const View& view : plan.views) {
    numbers.insert(numbers.end(), {view.p_map.x(), view.p_map.y(), view.direction, view.area, view.shown,
                                   view.overlap, view.distance, view.turn, view.value});
    numbers.push_back(view.gain);
  }
  for (const Vector2d& p : plan.path_map) numbers.insert(numbers.end(), {p.x(), p.y()});
  return numbers;
}

void ExpectRepeats(const ViewPlannerOptions& options, int times) {
  const std::vector<double> first = NumbersOf(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 7));
  EXPECT_GT(first.size(), 20U);
  for (int k = 1; k < times; ++k) {
    const std::vector<double> again = NumbersOf(PlanNextView(TwoRooms(), kInTheLeftRoom, options, 7));
    ASSERT_EQ(again.size(), first.size());
    ASSERT_EQ(std::memcmp(again.data(), first.data(), sizeof(double) * first.size()), 0);
  }
}

TEST(ViewPlanner, RepeatsItselfToTheByte) {
  for (const auto policy : {ViewPolicy::kExponential, ViewPolicy::kRandom, ViewPolicy::kTwoSteps})
    ExpectRepeats(OfPolicy(policy), 100);
  ExpectRepeats(PaperViewPlannerOptions(), 100);
}

/// OMPL numbers its generators in the order in which they are made.
TEST(ViewPlanner, RepeatsItselfToTheByteWithOmpl) {
  for (std::size_t i = 0; i < EnumNames<CandidateSampler>::value.size(); ++i) {
    ViewPlannerOptions options;
    options.sampler = static_cast<CandidateSampler>(i);
    options.candidates.count = 50;
    options.way = i % 2 == 0 ? WayLength::kRoadmap : WayLength::kGeodesic;
    SCOPED_TRACE(EnumNames<CandidateSampler>::value[i]);
    ExpectRepeats(options, 10);
  }
}

TEST(ViewPlanner, FindsFrontiersInAnyFrame) {
  const slam::Pose2 T_new_map{1.1, {40.0, -3.0}};
  const auto options = OfPolicy(ViewPolicy::kNearestFrontier);
  const ViewPlan here = PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1);
  const ViewPlan there =
      PlanNextView(MovedBy(T_new_map, TwoRooms()), T_new_map * kInTheLeftRoom, options, 1);
  ASSERT_TRUE(here.chosen && there.chosen);
  EXPECT_LT((T_new_map * here.views[*here.chosen].p_map - there.views[*there.chosen].p_map).norm(), 0.8);
}

TEST(ViewPlanner, RefusesWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { PlanNextView(TwoRooms(), {0.0, {nan, 0.0}}, {}, 1); }), testing::Ne(""));
  EXPECT_THAT(ErrorOf([&] {
                PlanNextView(TwoRooms(), {nan, {2.0, 2.0}}, {}, 1);
              }),
              testing::HasSubstr("heading"));
  std::vector<LabelledPolygon> area = TwoRooms();
  area[0].outer[3].p_map.y() = nan;
  EXPECT_THAT(ErrorOf([&] { PlanNextView(area, kInTheLeftRoom, {}, 1); }), testing::HasSubstr("no place"));
  ViewPlannerOptions options;
  options.robot_radius = -1.0;
  EXPECT_THAT(ErrorOf([&] { PlanNextView(TwoRooms(), kInTheLeftRoom, options, 1); }),
              testing::HasSubstr("planner.robot_radius"));
}

}  // namespace
}  // namespace ariadne::planning
