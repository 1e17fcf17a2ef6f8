#include "control/approach_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "control/simulate_approach.h"
#include "slam/base/random.h"
#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

TEST(ApproachStep, EachBehaviourReachesTheGoalWithinAllLimits) {
  RandomStream stream = NamedStream(1, "test/step");
  for (const auto behaviour : {ApproachBehaviour::kTurnFirst, ApproachBehaviour::kTurnStraightTurn}) {
    for (int trial = 0; trial < 100; ++trial) {
      const Pose2 start{DrawUniform(stream, -M_PI, M_PI),
                        {DrawUniform(stream, -7, 7), DrawUniform(stream, -7, 7)}};
      const ApproachResult result = SimulateApproach(start, {}, {}, behaviour);
      ASSERT_EQ(result.status, ApproachStatus::kReached);
      const Pose2& end = result.samples.back().T_map_robot;
      EXPECT_LE(end.translation.norm(), 0.01);
      EXPECT_LE(std::abs(end.angle), slam::RadFromDeg(0.5));
      DriveCommand before;
      for (const ApproachSample& sample : result.samples) {
        const DriveCommand& command = sample.command;
        ASSERT_GE(command.forward, 0.0);
        ASSERT_LE(command.forward, 0.8 + 1e-9);
        ASSERT_LE(std::abs(command.turning), 1.0 + 1e-9);
        ASSERT_LE(std::abs(command.forward - before.forward), 0.5 * 0.05 + 1e-9);
        ASSERT_LE(std::abs(command.turning - before.turning), 1.0 * 0.05 + 1e-9);
        before = command;
      }
      EXPECT_EQ(before.forward, 0.0);
    }
  }
}

TEST(ApproachStep, TurnsStandingBeforeItDrives) {
  const Pose2 start{2.0, {-3.0, 1.0}};
  const double bearing = std::atan2(-1.0, 3.0);
  for (const auto behaviour : {ApproachBehaviour::kTurnFirst, ApproachBehaviour::kTurnStraightTurn}) {
    const ApproachResult result = SimulateApproach(start, {}, {}, behaviour);
    std::size_t k = 0;
    while (result.samples[k].command.forward == 0.0) ++k;
    EXPECT_EQ(result.samples[k].T_map_robot.translation, start.translation);
    EXPECT_NEAR(result.samples[k].T_map_robot.angle, bearing, slam::RadFromDeg(0.25));
  }
  const ApproachResult straight = SimulateApproach(start, {}, {}, ApproachBehaviour::kTurnStraightTurn);
  EXPECT_NEAR(straight.length, std::sqrt(10.0), 0.01);
  EXPECT_NEAR(straight.turned, 2.0 - 2.0 * bearing, 0.05);
  EXPECT_LT(SimulateApproach(start, {}, {}, ApproachBehaviour::kTurnFirst).length,
            SimulateApproach(start, {}, {}).length);
}

TEST(ApproachStep, AtTheGoalOnlyTurns) {
  for (const auto behaviour : {ApproachBehaviour::kTurnFirst, ApproachBehaviour::kTurnStraightTurn}) {
    const ApproachResult result = SimulateApproach({2.0, {1.0, 1.0}}, {-1.0, {1.0, 1.0}}, {}, behaviour);
    EXPECT_EQ(result.length, 0.0);
    EXPECT_NEAR(result.turned, 3.0, 0.005);
  }
}

TEST(ApproachStep, ReachesTheGoalWithPosesThatErr) {
  RandomStream stream = NamedStream(2, "test/step");
  for (const auto behaviour : {ApproachBehaviour::kController, ApproachBehaviour::kTurnFirst,
                               ApproachBehaviour::kTurnStraightTurn}) {
    Pose2 pose{2.0, {-3.0, 1.0}};
    ApproachProgress progress;
    bool finished = false;
    for (int period = 0; period < 2000 && !finished; ++period) {
      const Pose2 seen = pose * Pose2::Exp({DrawNormal(stream, 0, 0.003), DrawNormal(stream, 0, 0.003),
                                            DrawNormal(stream, 0, 0.002)});
      const ApproachStep step = StepApproach(seen, progress, behaviour, {});
      progress = step.progress, finished = step.finished;
      pose = pose * Pose2::Exp({0.05 * step.command.forward, 0.0, 0.05 * step.command.turning});
    }
    EXPECT_TRUE(finished);
    EXPECT_LT(pose.translation.norm(), 0.03);
    EXPECT_LT(std::abs(pose.angle), 0.02);
  }
}

}  // namespace
}  // namespace ariadne::control
