// Many trajectories against a dense sweep: issue 7 asks for no miss and no more than 5 % of false alarms.
#include <gtest/gtest.h>

#include "control/resample_path.h"
#include "control/simulate_approach.h"
#include "tests/control/sweep_oracle.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr int kTrials = 100000;

/// Half of them arcs, half the controller's, towards a goal within 2 m.
std::vector<Pose2> DrawTrajectory(RandomStream& stream, int trial) {
  if (trial % 2 == 0) return DrawArcs(stream);
  const Pose2 goal{DrawUniform(stream, -M_PI, M_PI),
                   {DrawUniform(stream, -1.5, 1.5), DrawUniform(stream, -1.5, 1.5)}};
  ApproachOptions options;
  options.max_time = 8.0;
  return ResamplePath(SimulateApproach({}, goal, options).samples, {});
}

TEST(ManySweeps, OverlookNothingAndRarelyAlarm) {
  RandomStream stream = NamedStream(1, "test/sweeps");
  const RectangleOptions robot;
  int free = 0, alarms = 0, misses = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::vector<Pose2> poses = DrawTrajectory(stream, trial);
    const GroundObstacles obstacles{{DrawOutline(stream), DrawOutline(stream)}, {}};
    const bool hit = FirstHit(robot, poses, obstacles).has_value();
    const bool hits_densely = DenselyHits(robot, poses, obstacles.outlines, 0.01);
    misses += hits_densely && !hit ? 1 : 0;
    free += hits_densely ? 0 : 1;
    alarms += hit && !hits_densely ? 1 : 0;
  }
  RecordProperty("free", free);
  RecordProperty("alarms", alarms);
  EXPECT_EQ(misses, 0);
  EXPECT_GT(free, kTrials / 10);
  EXPECT_LT(free, kTrials * 9 / 10);
  EXPECT_LE(alarms, 0.05 * free);
}

}  // namespace
}  // namespace ariadne::control
