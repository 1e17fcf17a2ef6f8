#include "control/path_leg.h"

#include <gtest/gtest.h>

#include "tests/control/random_path.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr double kCorner = 0.7;

TEST(PathLeg, EndsAtCuspsAndTurns) {
  const std::vector<Pose2> path = PathOf(
      {1.0, {2.0, 3.0}}, {{1.0, 0.5}, {0.5, 0.0}, {-0.8, 0.7}, {0.0, -2.0}, {0.0, 4.0}, {-0.1, 0.0}});
  const std::vector<PathLeg> legs = LegsOf(path, kCorner);
  ASSERT_EQ(legs.size(), 5U);
  EXPECT_EQ(legs[0].kind, LegKind::kForward);
  EXPECT_NEAR(legs[0].length, 1.5, 1e-3);
  EXPECT_EQ(legs[1].kind, LegKind::kBackward);
  EXPECT_NEAR(legs[1].length, 0.8, 1e-3);
  EXPECT_EQ(legs[2].kind, LegKind::kTurn);
  EXPECT_NEAR(legs[2].length, -2.0, 1e-9);
  EXPECT_NEAR(legs[3].length, 4.0, 1e-9);
  EXPECT_EQ(legs[4].kind, LegKind::kBackward);
  EXPECT_EQ(legs.front().first, 0U);
  EXPECT_EQ(legs.back().last + 1, path.size());
  for (std::size_t k = 1; k < legs.size(); ++k) EXPECT_EQ(legs[k].first, legs[k - 1].last);
}

TEST(PathLeg, EndsAtCorners) {
  const std::vector<Pose2> path{
      {0.0, {0, 0}}, {0.0, {1, 0}}, {1.5, {1, 1}}, {1.5, {1, 2}}, {1.2, {1.4, 3}}};
  const std::vector<PathLeg> legs = LegsOf(path, kCorner);
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_EQ(legs[0].last, 1U);
  EXPECT_EQ(legs[1].kind, LegKind::kForward);
}

TEST(PathLeg, PassesPosesThatDoNotMove) {
  const std::vector<Pose2> path{
      {0.0, {0, 0}}, {0.0, {0, 0}}, {0.0, {-1, 0}}, {0.0, {-1, 0}}, {0.0, {-2, 0}}};
  const std::vector<PathLeg> legs = LegsOf(path, kCorner);
  ASSERT_EQ(legs.size(), 1U);
  EXPECT_EQ(legs[0].kind, LegKind::kBackward);
  EXPECT_EQ(legs[0].length, 2.0);
  EXPECT_TRUE(LegsOf({path[0]}, kCorner).empty());
  EXPECT_EQ(LegsOf({path[0], path[1]}, kCorner).front().length, 0.0);
  const DrivenLeg leg(path, legs[0]);
  EXPECT_NEAR(leg.MotionAt(0.0).translation.x(), 0.0, 1e-12);
  EXPECT_NEAR(leg.MotionAt(1.0).translation.x(), -1.0, 1e-12);
}

TEST(DrivenLeg, IsOnItsArc) {
  RandomStream stream = NamedStream(1, "test/leg");
  for (const double sense : {1.0, -1.0}) {
    const Pose2 start{0.4, {2.0, 1.0}};
    const std::vector<Pose2> path = PathOf(start, {{sense * 1.5, 1.9}});
    const DrivenLeg leg(path, LegFrom(path, 0, kCorner));
    for (int trial = 0; trial < 100; ++trial) {
      const double share = DrawUniform(stream, 0.0, 1.0);
      const Pose2 exact = start * Pose2::Exp({sense * share * 1.5, 0.0, share * 1.9});
      const Pose2 motion = leg.MotionAt(share * leg.length());
      EXPECT_LT((motion.translation - exact.translation).norm(), 1e-4);
      EXPECT_NEAR(std::cos(motion.angle - exact.angle), sense, 1e-8);
      EXPECT_NEAR(leg.NearestWay(exact * Eigen::Vector2d(0.0, 0.02), 0.0, 9.0), share * leg.length(), 5e-3);
    }
    const Pose2 beyond = leg.MotionAt(leg.length() + 0.5);
    EXPECT_LT((beyond.translation - path.back() * Eigen::Vector2d(sense * 0.5, 0.0)).norm(), 1e-4);
  }
}

/// A pose that is there twice, but for rounding: the way on from its end is the leg's, not the rounding's.
TEST(DrivenLeg, GoesOnAsBeforeAPoseThatIsThereTwice) {
  const std::vector<Pose2> path{{0.3, {0, 0}}, {0.3, {-0.1, -0.03}}, {0.3, {-0.1, -0.03 + 5e-16}}};
  const PathLeg leg = LegFrom(path, 0, kCorner);
  ASSERT_EQ(leg.kind, LegKind::kBackward);
  const Pose2 beyond = DrivenLeg(path, leg).MotionAt(leg.length + 0.1);
  const Eigen::Vector2d direction = Eigen::Vector2d(-0.1, -0.03).normalized();
  EXPECT_NEAR((beyond.translation - path[1].translation).dot(direction), 0.1, 1e-3);
}

TEST(DrivenLeg, LooksForTheNearestWhereItIsTold) {
  const std::vector<Pose2> path = PathOf({}, {{2.0, 2.0 * M_PI}});  // a circle
  const DrivenLeg leg(path, LegFrom(path, 0, kCorner));
  EXPECT_NEAR(leg.NearestWay({0.0, 0.0}, 0.0, 0.5), 0.0, 1e-9);
  EXPECT_NEAR(leg.NearestWay({0.0, 0.0}, 1.0, 9.0), leg.length(), 1e-9);
  EXPECT_NEAR(leg.NearestWay({0.0, 0.0}, 0.3, 0.5), 0.3, 1e-9);
}

}  // namespace
}  // namespace ariadne::control
