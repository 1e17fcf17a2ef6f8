#include "control/approach_plan.h"

#include <gtest/gtest.h>

#include "tests/control/sweep_oracle.h"

namespace ariadne::control {
namespace {

using slam::Pose2;
using slam::Ring;

// It stands with its back to a goal 4 m away, at which it is to look sideways.
const Pose2 kStart{2.6, {-4.0, 0.0}};
const Pose2 kGoal{1.4, {0.0, 0.0}};

Ring BoxAt(double x, double y) { return BoxOutline({0.4, {x, y}}, 0.3, 0.2); }

ApproachPlan PlanAmong(std::vector<Ring> boxes) {
  return PlanApproach(kStart, kGoal, {std::move(boxes), {}}, {});
}

/// Whether a behaviour alone is free, densely tested.
bool IsFreeAlone(ApproachBehaviour behaviour, const std::vector<Ring>& boxes) {
  std::vector<Pose2> poses;
  for (const ApproachSample& sample : SimulateApproach(kStart, kGoal, {}, behaviour).samples)
    poses.push_back(sample.T_map_robot);
  return !DenselyHits({}, poses, boxes, 0.005);
}

void ExpectTaken(const std::vector<Ring>& boxes, ApproachBehaviour behaviour) {
  const ApproachPlan plan = PlanAmong(boxes);
  EXPECT_TRUE(plan.IsFree());
  EXPECT_EQ(plan.behaviour(), behaviour);
  EXPECT_TRUE(IsFreeAlone(behaviour, boxes));
  for (std::size_t k = 0; k + 1 < plan.attempts.size(); ++k) {
    EXPECT_FALSE(plan.attempts[k].IsFree());
    EXPECT_FALSE(IsFreeAlone(plan.attempts[k].behaviour, boxes));
  }
  EXPECT_EQ(plan.trajectory.length, SimulateApproach(kStart, kGoal, {}, behaviour).length);
}

TEST(ApproachPlan, TakesTheControllerWhereNothingIsInItsWay) {
  ExpectTaken({}, ApproachBehaviour::kController);
  ExpectTaken({BoxAt(-2.0, 3.5)}, ApproachBehaviour::kController);
}

TEST(ApproachPlan, TurnsFirstWhereTheLargeRadiusIsBlocked) {
  ExpectTaken({BoxAt(-3.5, 1.3)}, ApproachBehaviour::kTurnFirst);
}

TEST(ApproachPlan, DrivesStraightWhereEachCurveIsBlocked) {
  ExpectTaken({BoxAt(-3.5, 1.3), BoxAt(-1.0, -1.0)}, ApproachBehaviour::kTurnStraightTurn);
}

TEST(ApproachPlan, SaysWhereEachFails) {
  const ApproachPlan plan = PlanAmong({BoxAt(-3.5, 1.3), BoxAt(-2.0, 0.0), BoxAt(-1.0, -1.0)});
  EXPECT_FALSE(plan.IsFree());
  ASSERT_EQ(plan.attempts.size(), 3U);
  for (const ApproachAttempt& attempt : plan.attempts) {
    EXPECT_EQ(attempt.status, ApproachStatus::kReached);
    ASSERT_TRUE(attempt.hit.has_value());
  }
  EXPECT_EQ(plan.attempts[0].hit->obstacle, 0U);
  EXPECT_EQ(plan.attempts[2].hit->obstacle, 1U);
  EXPECT_NEAR(plan.attempts[2].hit->T_map_robot.translation.x(), -2.0 - 0.45 - 0.18, 0.03);
}

TEST(ApproachPlan, TakesNoApproachThatDoesNotArrive) {
  ApproachPlanOptions options;
  options.approach.max_excursion = 0.01;
  const ApproachPlan plan = PlanApproach(kStart, kGoal, {}, options);
  EXPECT_TRUE(plan.IsFree());
  EXPECT_EQ(plan.attempts[0].status, ApproachStatus::kLeftBehind);
  EXPECT_FALSE(plan.attempts[0].IsFree());
  EXPECT_EQ(plan.behaviour(), ApproachBehaviour::kTurnFirst);
}

TEST(ApproachPlan, CannotLeaveAPlaceThatIsNotFree) {
  EXPECT_FALSE(PlanAmong({BoxAt(-4.0, 0.2)}).IsFree());
  EXPECT_EQ(PlanAmong({BoxAt(-4.0, 0.2)}).attempts[0].hit->interval, 0U);
}

}  // namespace
}  // namespace ariadne::control
