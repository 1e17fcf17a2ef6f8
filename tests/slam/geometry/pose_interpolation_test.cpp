#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
class PoseInterpolation : public testing::Test {
 protected:
  PoseInterpolation() {
    RandomStream stream = NamedStream(1, "pose_interpolation_test");
    for (const auto& way : SampleTangents<Pose>()) {
      const Pose from = Pose::Exp(TangentWith<Pose>(10.0, 2.0, stream));
      pairs_.push_back({from, from * Pose::Exp(way), way});
    }
  }

  struct Pair {
    Pose from;
    Pose to;
    typename Pose::Tangent way;
  };
  std::vector<Pair> pairs_;
};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(PoseInterpolation, Poses);

TYPED_TEST(PoseInterpolation, StartsAndEndsAtThePoses) {
  for (const auto& [from, to, way] : this->pairs_) {
    EXPECT_THAT(Interpolate(from, to, 0.0), NearPose(from, 1e-14));
    EXPECT_THAT(Interpolate(from, to, 1.0), NearPose(to, 1e-14));
  }
}

TYPED_TEST(PoseInterpolation, HasTheSameMidpointFromBothEnds) {
  for (const auto& [from, to, way] : this->pairs_) {
    const TypeParam midpoint = Interpolate(from, to, 0.5);
    const TypeParam half = from.Inverse() * midpoint;
    EXPECT_THAT(half * half, NearPose(from.Inverse() * to, 2e-13));
    // Near pi the way back may turn on the other side, by rounding.
    if (RotationPart<TypeParam>(way).norm() < 3.1) {
      EXPECT_THAT(Interpolate(to, from, 0.5), NearPose(midpoint, 2e-13));
    }
  }
}

TYPED_TEST(PoseInterpolation, MovesAtConstantSpeed) {
  for (const auto& [from, to, way] : this->pairs_) {
    if (RotationPart<TypeParam>(way).norm() > 3.1) continue;
    for (const double s : {0.0, 0.25, 0.7}) {
      const TypeParam step = Interpolate(from, to, s).Inverse() * Interpolate(from, to, s + 0.2);
      EXPECT_THAT(step.Log(), NearMatrix(0.2 * way, 1e-12));
    }
  }
}

TYPED_TEST(PoseInterpolation, ExtrapolatesAlongTheSameMotion) {
  for (const auto& [from, to, way] : this->pairs_) {
    EXPECT_THAT(Interpolate(from, to, 2.0), NearPose(to * (from.Inverse() * to), 2e-13));
    EXPECT_THAT(Interpolate(from, to, -1.0), NearPose(from * (to.Inverse() * from), 2e-13));
  }
}

TEST(Interpolate, FollowsTheArcOfADrivingRobot) {
  const Pose2 start;
  const Pose2 quarter_turn{std::numbers::pi / 2.0, {1.0, 1.0}};  // on the circle around (0, 1)
  const Pose2 midpoint = Interpolate(start, quarter_turn, 0.5);
  EXPECT_NEAR(midpoint.angle, std::numbers::pi / 4.0, 1e-15);
  EXPECT_THAT(midpoint.translation,
              NearMatrix(Eigen::Vector2d(std::sqrt(0.5), 1.0 - std::sqrt(0.5)), 1e-15));
}

}  // namespace
}  // namespace ariadne::slam
