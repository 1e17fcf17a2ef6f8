#include "slam/geometry/euler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "slam/base/random.h"
#include "slam/geometry/angles.h"
#include "tests/slam/geometry/matrix_matchers.h"

namespace ariadne::slam {
namespace {

Eigen::Vector3d FromDegrees(double x, double y, double z) {
  return {RadFromDeg(x), RadFromDeg(y), RadFromDeg(z)};
}

TEST(RotationFromEulerXyz, TurnsByTheRightHandRuleAboutEachAxis) {
  EXPECT_THAT(RotationFromEulerXyz(FromDegrees(90, 0, 0)) * Eigen::Vector3d::UnitY(),
              NearMatrix(Eigen::Vector3d::UnitZ(), 1e-15));
  EXPECT_THAT(RotationFromEulerXyz(FromDegrees(0, 90, 0)) * Eigen::Vector3d::UnitZ(),
              NearMatrix(Eigen::Vector3d::UnitX(), 1e-15));
  EXPECT_THAT(RotationFromEulerXyz(FromDegrees(0, 0, 90)) * Eigen::Vector3d::UnitX(),
              NearMatrix(Eigen::Vector3d::UnitY(), 1e-15));
}

TEST(RotationFromEulerXyz, IsTheProductXThenYThenZWorkedOutByHand) {
  const double c = std::numbers::sqrt3 / 2.0;
  const double s = 0.5;
  Eigen::Matrix3d expected;  // Rx(90) * Ry(30) * Rz(90)
  expected << 0.0, -c, s,    //
      0.0, -s, -c,           //
      1.0, 0.0, 0.0;
  EXPECT_THAT(RotationFromEulerXyz(FromDegrees(90, 30, 90)), NearMatrix(expected, 1e-15));
  EXPECT_THAT(EulerXyzFromRotation(expected), NearMatrix(FromDegrees(90, 30, 90), 1e-15));
}

TEST(EulerXyz, RoundTripsOnAGrid) {
  for (int x = -180 + 15; x <= 180; x += 15) {
    for (int y = -75; y <= 75; y += 15) {
      for (int z = -180 + 15; z <= 180; z += 15) {
        // The cuts at 180 deg belong to either sign, by rounding.
        const Eigen::Vector3d angles = FromDegrees(x == 180 ? 179.99 : x, y, z == 180 ? 179.99 : z);
        EXPECT_THAT(EulerXyzFromRotation(RotationFromEulerXyz(angles)), NearMatrix(angles, 4e-15));
      }
    }
  }
}

TEST(EulerXyz, RoundTripsForTinyAngles) {
  for (const double size : {1e-15, 1e-12, 1e-9, 1e-6}) {
    const Eigen::Vector3d angles = size * Eigen::Vector3d(1.0, -2.0, 0.5);
    EXPECT_THAT(EulerXyzFromRotation(RotationFromEulerXyz(angles)), NearMatrix(angles, 1e-15 * size));
  }
}

TEST(EulerXyz, AnglesBeyondTheirRangeGiveTheSameRotation) {
  const Eigen::Vector3d beyond = FromDegrees(200, 120, -300);
  const Eigen::Vector3d angles = EulerXyzFromRotation(RotationFromEulerXyz(beyond));
  EXPECT_THAT(RotationFromEulerXyz(angles), NearMatrix(RotationFromEulerXyz(beyond), 1e-15));
  EXPECT_THAT(angles, NearMatrix(FromDegrees(20, 60, -120), 1e-14));
}

TEST(EulerXyz, EveryRandomRotationComesBack) {
  RandomStream stream = NamedStream(1, "euler_test/rotations");
  for (int repeat = 0; repeat < 1000; ++repeat) {
    Eigen::Quaterniond q;
    for (double& x : q.coeffs()) x = DrawNormal(stream, 0.0, 1.0);
    const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
    EXPECT_THAT(RotationFromEulerXyz(EulerXyzFromRotation(R)), NearMatrix(R, 3e-15));
  }
}

class GimbalLock : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(BothSigns, GimbalLock, testing::Values(90.0, -90.0));

TEST_P(GimbalLock, GivesTheSameRotationWithZeroAboutZ) {
  for (const double x : {-170.0, -30.0, 0.0, 45.0, 100.0}) {
    for (const double z : {-120.0, 0.0, 10.0, 77.0}) {
      const Eigen::Matrix3d R = RotationFromEulerXyz(FromDegrees(x, GetParam(), z));
      const Eigen::Vector3d angles = EulerXyzFromRotation(R);
      EXPECT_NEAR(angles.y(), RadFromDeg(GetParam()), 1e-15);
      EXPECT_EQ(angles.z(), 0.0);
      EXPECT_NEAR(WrapAngle(angles.x() - RadFromDeg(GetParam() > 0.0 ? x + z : x - z)), 0.0, 2e-15);
      EXPECT_THAT(RotationFromEulerXyz(angles), NearMatrix(R, 2e-15));
    }
  }
}

// Near the lock each of the outer angles is uncertain, but not the rotation that they make together.
TEST_P(GimbalLock, LosesNoDigitsOfTheRotationNearby) {
  for (double rest = 1e-1; rest > 1e-17; rest /= 3.0) {
    const double y = RadFromDeg(GetParam()) * (1.0 - rest);
    const Eigen::Matrix3d R = RotationFromEulerXyz({0.7, y, -2.1});
    const double tolerance = rest > 1e-12 ? 4e-15 : 2e-12;  // nearer, it is taken for the lock
    EXPECT_THAT(RotationFromEulerXyz(EulerXyzFromRotation(R)), NearMatrix(R, tolerance)) << "at " << rest;
  }
}

}  // namespace
}  // namespace ariadne::slam
