#include "drivers/simulated/world.h"

#include <gtest/gtest.h>

#include <numbers>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;

slam::Pose3 Facing(double heading, const Vector3d& place) {
  return slam::Pose3{Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ())), place};
}

TEST(PoseAt, GoesStraightAndTurnsEvenly) {
  const Motion motion{
      {1.0, 3.0, 4.0},
      {Facing(0.0, {0, 0, 0}), Facing(std::numbers::pi / 2, {4, 2, 0}), Facing(0.3, {4, 2, 1})}};
  const slam::Pose3 quarter = PoseAt(motion, 1.5);
  EXPECT_NEAR((quarter.translation - Vector3d(1, 0.5, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(slam::RotationDistance(quarter, Facing(std::numbers::pi / 8, {0, 0, 0})), 0.0, 1e-12);
  EXPECT_EQ(PoseAt(motion, 3.0).translation, Vector3d(4, 2, 0)) << "key frames are met exactly";
  EXPECT_NEAR((PoseAt(motion, 3.5).translation - Vector3d(4, 2, 0.5)).norm(), 0.0, 1e-15);
}

TEST(PoseAt, StandsBeforeAndAfter) {
  const Motion motion{{1.0, 2.0}, {Facing(0.1, {1, 2, 3}), Facing(0.2, {4, 5, 6})}};
  EXPECT_EQ(PoseAt(motion, -1e9).translation, Vector3d(1, 2, 3));
  EXPECT_EQ(PoseAt(motion, 1e9).translation, Vector3d(4, 5, 6));
  EXPECT_EQ(PoseAt({{5.0}, {Facing(0.1, {1, 2, 3})}}, 0.0).translation, Vector3d(1, 2, 3))
      << "one key: a place";
  EXPECT_EQ(PoseAt({}, 0.0).translation, Vector3d::Zero()) << "none: the frame of the map";
}

TEST(PoseAt, TurnsTheShortWay) {
  const Motion motion{{0.0, 1.0}, {Facing(3.0, {0, 0, 0}), Facing(-3.0, {0, 0, 0})}};
  EXPECT_NEAR(slam::RotationDistance(PoseAt(motion, 0.5), Facing(std::numbers::pi, {0, 0, 0})), 0.0, 1e-12);
}

TEST(RequireSound, NamesWhatIsWrong) {
  EXPECT_NO_THROW(RequireSound(Motion{}, "table"));
  EXPECT_THROW(RequireSound(Motion{{0.0, 1.0}, {{}}}, "table"), Error);
  EXPECT_THROW(RequireSound(Motion{{std::nan("")}, {{}}}, "table"), Error);
}

}  // namespace
}  // namespace ariadne::drivers
