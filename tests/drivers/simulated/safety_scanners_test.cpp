#include "drivers/simulated/safety_scanners.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/simulated/sweep_beams.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {
namespace {

SafetyScannerOptions ExactSafety() {
  SafetyScannerOptions options;
  options.range_finder = WithoutErrors(options.range_finder);
  return options;
}

TEST(SafetySweeps, LookAheadAndBack) {
  const RayScene scene(EmptyRoom({-3, -2, 0}, {5, 4, 3}));
  const auto sweeps = TakeSafetySweeps(scene, Standing({}), 3.0, ExactSafety(), 1, 0);
  ASSERT_EQ(sweeps.size(), 2u);
  const auto& front = sweeps[0].sweep.ranges;
  const auto& rear = sweeps[1].sweep.ranges;
  ASSERT_EQ(front.size(), 361u);
  EXPECT_NEAR(front[180], 4.6, 1e-6);
  EXPECT_NEAR(front[0], 2.0, 1e-6) << "right of the robot";
  EXPECT_NEAR(front[360], 4.0, 1e-6);
  EXPECT_NEAR(rear[180], 2.6, 1e-6);
  EXPECT_NEAR(rear[0], 4.0, 1e-6) << "left of the robot";
  EXPECT_NEAR(rear[360], 2.0, 1e-6);
  EXPECT_EQ(sweeps[1].sweep.stamp, 3.0);
}

TEST(SafetySweeps, SayWhereTheirPointsAre) {
  const slam::Box3 room(Eigen::Vector3d(-3, -2, 0), Eigen::Vector3d(5, 4, 3));
  const slam::Pose3 T_map_base = slam::ToPose3(slam::Pose2{0.4, {0.5, 0.3}});
  const auto sweeps = TakeSafetySweeps(RayScene(EmptyRoom(room.min(), room.max())), Standing(T_map_base),
                                       0.0, ExactSafety(), 1, 0);
  for (const SafetySweep& s : sweeps) {
    for (std::size_t b = 0; b < s.sweep.ranges.size(); ++b) {
      const Eigen::Vector3d p_laser = s.sweep.ranges[b] * slam::BeamDirection(s.scanner, b, 0.0);
      const Eigen::Vector3d p = T_map_base * (s.T_base_laser * p_laser);
      EXPECT_NEAR(p.z(), ExactSafety().height, 1e-9);
      const Eigen::Vector2d off_min = (p - room.min()).head<2>().cwiseAbs();
      const Eigen::Vector2d off_max = (room.max() - p).head<2>().cwiseAbs();
      EXPECT_LT(std::min(off_min.minCoeff(), off_max.minCoeff()), 1e-5);
    }
  }
}

TEST(SafetySweeps, ErrByThemselves) {
  const RayScene scene(EmptyRoom({-4, -4, 0}, {4, 4, 3}));  // the same to the front and to the rear
  const auto sweeps = TakeSafetySweeps(scene, Standing({}), 0.0, {}, 1, 0);
  EXPECT_NE(sweeps[0].sweep.ranges, sweeps[1].sweep.ranges);
  const auto next = TakeSafetySweeps(scene, Standing({}), 0.0, {}, 1, 1);
  EXPECT_NE(sweeps[0].sweep.ranges, next[0].sweep.ranges);
}

TEST(SafetySweeps, AreNoneWhereNoneAreInstalled) {
  SafetyScannerOptions options;
  options.installed = false;
  EXPECT_TRUE(TakeSafetySweeps(RayScene(FurnishedRoom()), Standing({}), 0.0, options, 1, 0).empty());
}

}  // namespace
}  // namespace ariadne::drivers
