#include "slam/geometry/pose2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

using std::numbers::pi;

TEST(Pose2, TurnsAnticlockwiseAndThenShifts) {
  const Pose2 T_map_base{pi / 2.0, {10.0, 20.0}};
  EXPECT_THAT(T_map_base * Eigen::Vector2d(1.0, 0.0), NearMatrix(Eigen::Vector2d(10.0, 21.0), 1e-15));
  EXPECT_THAT(T_map_base * Eigen::Vector2d(0.0, 1.0), NearMatrix(Eigen::Vector2d(9.0, 20.0), 1e-15));
}

TEST(Pose2, KeepsItsAngleInTheHalfOpenInterval) {
  const Pose2 half_turn{pi, {1.0, 0.0}};
  EXPECT_EQ(half_turn.Inverse().angle, pi);
  EXPECT_EQ((half_turn * half_turn).angle, 0.0);
  EXPECT_EQ(Pose2::Exp({0.0, 0.0, -pi}).angle, pi);
  const Pose2 three_quarters = Pose2{pi / 2.0, {}} * half_turn;
  EXPECT_NEAR(three_quarters.angle, -pi / 2.0, 1e-15);
}

TEST(Pose2, ExpFollowsTheHalfCircle) {
  const Pose2 half_circle = Pose2::Exp({pi, 0.0, pi});  // pi metres along the circle of radius 1 m
  EXPECT_EQ(half_circle.angle, pi);
  EXPECT_THAT(half_circle.translation, NearMatrix(Eigen::Vector2d(0.0, 2.0), 1e-15));
  EXPECT_THAT(half_circle.Log(), NearMatrix(Eigen::Vector3d(pi, 0.0, pi), 1e-15));
}

TEST(Pose2, ExpKeepsTheDigitsOfTinyArcs) {
  for (const double angle : SampleAngles()) {
    for (const double signed_angle : {angle, -angle}) {
      const Eigen::Vector2d translation = Pose2::Exp({1.0, 0.0, signed_angle}).translation;
      const long double half_sine = std::sin(static_cast<long double>(signed_angle) / 2);
      const auto sideways =
          signed_angle == 0.0 ? 0.0 : static_cast<double>(2 * half_sine * half_sine / signed_angle);
      EXPECT_NEAR(translation.y(), sideways, 4e-15 * std::abs(sideways)) << signed_angle;
    }
  }
}

TEST(Pose2, BecomesAPoseInSpace) {
  const std::vector<Pose2> poses = SamplePoses<Pose2>();
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Pose3 in_space = ToPose3(poses[i]);
    EXPECT_THAT(
        in_space * Eigen::Vector3d(3.0, -2.0, 0.0),
        NearMatrix((Eigen::Vector3d() << poses[i] * Eigen::Vector2d(3.0, -2.0), 0.0).finished(), 2e-14));
    EXPECT_THAT(in_space * Eigen::Vector3d::UnitZ() - in_space.translation,
                NearMatrix(Eigen::Vector3d::UnitZ(), 1e-15));
    EXPECT_THAT(ToPose3(poses[i] * poses[i + 1]), NearPose(in_space * ToPose3(poses[i + 1]), 2e-14));
    EXPECT_THAT(ToPose3(poses[i].Inverse()), NearPose(in_space.Inverse(), 2e-14));
  }
}

TEST(Pose2, HasTheTangentOfThePoseInSpace) {
  for (const Pose2::Tangent& tau : SampleTangents<Pose2>()) {
    Pose3::Tangent in_space = Pose3::Tangent::Zero();
    in_space << tau.x(), tau.y(), 0.0, 0.0, 0.0, tau.z();
    EXPECT_THAT(ToPose3(Pose2::Exp(tau)), NearPose(Pose3::Exp(in_space), 2e-15));
    EXPECT_THAT(ToPose3(Pose2::Exp(tau)).Log(), NearMatrix(in_space, 1e-13));
  }
}

}  // namespace
}  // namespace ariadne::slam
