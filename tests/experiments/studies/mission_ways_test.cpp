// What the missions of a study do otherwise.
#include "experiments/studies/mission_ways.h"

#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

/// The planner of 2003 hardly leaves its place: scans beyond a number tell nothing more.
TEST(MissionWays, MissionsWithThePlannerOf2003HaveALimitOfTheirOwn) {
  MissionOptions mission;
  MissionVariantOptions variants;
  variants.paper_scans = 40;
  variants.planners = "paper, gain";
  mission.limits.max_scans = 90;
  const std::vector<MissionVariant> ways = MissionVariants(mission, MissionRobotOptions(), variants);
  ASSERT_EQ(ways.size(), 4U);
  EXPECT_EQ(ways[0].mission.limits.max_scans, 90);
  EXPECT_EQ(ways[1].name, "2003");
  EXPECT_EQ(ways[1].mission.limits.max_scans, 40);
  EXPECT_EQ(ways[2].mission.limits.max_scans, 40);
  EXPECT_EQ(ways[3].mission.limits.max_scans, 90);
  mission.limits.max_scans = 7;
  EXPECT_EQ(MissionVariants(mission, MissionRobotOptions(), variants)[1].mission.limits.max_scans, 7);
}

TEST(MissionWays, OneThingAtATimeIsOtherwise) {
  MissionVariantOptions variants;
  variants.paper = false;
  variants.matching = "pairwise, simultaneous";
  variants.planners = "paper, gain";
  variants.noises = "0, 2";
  const drivers::SimulatedRobotOptions robot = MissionRobotOptions();
  const std::vector<MissionVariant> ways = MissionVariants({}, robot, variants);
  ASSERT_EQ(ways.size(), 7U);
  const MissionOptions usual;
  EXPECT_EQ(ways[1].mission.mapper.registration.method, slam::MatchMethod::kPairwise);
  EXPECT_EQ(ways[1].mission.planner.policy, usual.planner.policy);
  EXPECT_EQ(ways[3].mission.planner.view.distance_weight, 5.0);
  EXPECT_EQ(ways[3].mission.mapper.registration.method, usual.mapper.registration.method);
  EXPECT_EQ(ways[4].mission.planner.policy, planning::ViewPolicy::kGain);
  EXPECT_EQ(ways[5].robot.base.wheels.slip, 0.0);
  EXPECT_EQ(ways[6].robot.base.wheels.slip, 2.0 * robot.base.wheels.slip);
}

}  // namespace
}  // namespace ariadne::experiments
