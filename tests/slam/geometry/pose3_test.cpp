#include "slam/geometry/pose3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

using std::numbers::pi;

Pose3 QuarterTurnAboutZ() {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2.0, Eigen::Vector3d::UnitZ())), {10.0, 20.0, 30.0}};
}

TEST(Pose3, TurnsAnticlockwiseAboutZAndThenShifts) {
  EXPECT_THAT(QuarterTurnAboutZ() * Eigen::Vector3d(1.0, 0.0, 5.0),
              NearMatrix(Eigen::Vector3d(10.0, 21.0, 35.0), 1e-14));
}

TEST(Pose3, MatrixIsTheHomogeneousTransform) {
  Eigen::Matrix4d expected;
  expected << 0.0, -1.0, 0.0, 10.0,  //
      1.0, 0.0, 0.0, 20.0,           //
      0.0, 0.0, 1.0, 30.0,           //
      0.0, 0.0, 0.0, 1.0;
  EXPECT_THAT(QuarterTurnAboutZ().Matrix(), NearMatrix(expected, 1e-15));
  EXPECT_THAT(Pose3::FromMatrix(expected), NearPose(QuarterTurnAboutZ(), 1e-15));
}

TEST(Pose3, ComesBackFromItsMatrix) {
  for (const Pose3& pose : SamplePoses<Pose3>()) {
    EXPECT_THAT(Pose3::FromMatrix(pose.Matrix()), NearPose(pose, 2e-15));
  }
}

TEST(Pose3, FromMatrixMakesARotationOfRoundedDigits) {
  for (const Pose3& pose : SamplePoses<Pose3>()) {
    const Eigen::Matrix4d rounded = (pose.Matrix() * 1e4).array().round() / 1e4;  // as text files have them
    const Pose3 read = Pose3::FromMatrix(rounded);
    EXPECT_NEAR(read.rotation.norm(), 1.0, 1e-15);
    EXPECT_THAT(read, NearPose(pose, 2e-4));
  }
}

TEST(Pose3, CompositionKeepsTheQuaternionAtUnitLength) {
  Pose3 chain;
  for (int repeat = 0; repeat < 100'000; ++repeat) chain = chain * QuarterTurnAboutZ();
  EXPECT_NEAR(chain.rotation.norm(), 1.0, 1e-15);
}

TEST(Pose3, ExpIsAScrew) {
  const Pose3 screw = Pose3::Exp((Pose3::Tangent() << 0.0, 0.0, 2.0, 0.0, 0.0, pi / 2.0).finished());
  EXPECT_THAT(screw * Eigen::Vector3d(1.0, 0.0, 0.0), NearMatrix(Eigen::Vector3d(0.0, 1.0, 2.0), 1e-15));
}

TEST(Pose3, DistancesAreThoseOfTheMotionBetween) {
  RandomStream stream = NamedStream(1, "pose3_test/distances");
  for (const double angle : SampleAngles()) {
    const Pose3 a = Pose3::Exp(TangentWith<Pose3>(5.0, 2.0, stream));
    const Pose3 b =
        a * Pose3{Pose3::Exp(TangentWith<Pose3>(0.0, angle, stream)).rotation, {3.0, 0.0, -4.0}};
    EXPECT_NEAR(RotationDistance(a, b), angle, 2e-15);
    EXPECT_NEAR(RotationDistance(b, a), angle, 2e-15);
    EXPECT_NEAR(TranslationDistance(a, b), 5.0, 1e-14);
    EXPECT_NEAR(TranslationDistance(b, a), 5.0, 1e-14);
  }
}

TEST(Pose3, RotationDistanceDoesNotSeeTheSignOfTheQuaternion) {
  const Pose3 pose = QuarterTurnAboutZ();
  const Pose3 same{Eigen::Quaterniond(-pose.rotation.coeffs()), pose.translation};
  EXPECT_NEAR(RotationDistance(pose, same), 0.0, 1e-15);
}

TEST(Pose3, IsFiniteSeesEveryNumber) {
  EXPECT_TRUE(IsFinite(QuarterTurnAboutZ()));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int k = 0; k < 4; ++k) {
      Pose3 pose = QuarterTurnAboutZ();
      pose.rotation.coeffs()[k] = bad;
      EXPECT_FALSE(IsFinite(pose)) << "rotation " << k;
    }
    for (int k = 0; k < 3; ++k) {
      Pose3 pose = QuarterTurnAboutZ();
      pose.translation[k] = bad;
      EXPECT_FALSE(IsFinite(pose)) << "translation " << k;
    }
  }
}

}  // namespace
}  // namespace ariadne::slam
