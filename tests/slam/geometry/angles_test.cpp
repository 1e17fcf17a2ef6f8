#include "slam/geometry/angles.h"

#include <gtest/gtest.h>

#include <limits>

namespace ariadne::slam {
namespace {

using std::numbers::pi;

TEST(Angles, ConvertBetweenDegreesAndRadians) {
  EXPECT_DOUBLE_EQ(RadFromDeg(180.0), pi);
  EXPECT_DOUBLE_EQ(RadFromDeg(-30.0), -pi / 6.0);
  EXPECT_DOUBLE_EQ(DegFromRad(pi / 2.0), 90.0);
  EXPECT_DOUBLE_EQ(DegFromRad(RadFromDeg(0.47)), 0.47);
}

TEST(WrapAngle, KeepsAnglesInsideTheInterval) {
  for (const double rad :
       {0.0, 1e-300, -1e-12, 1.0, -3.0, std::nextafter(pi, 0.0), -std::nextafter(pi, 0.0)}) {
    EXPECT_EQ(WrapAngle(rad), rad);
  }
}

TEST(WrapAngle, GivesPlusPiForBothHalfTurns) {
  EXPECT_EQ(WrapAngle(pi), pi);
  EXPECT_EQ(WrapAngle(-pi), pi);
}

TEST(WrapAngle, WrapsJustBeyondPi) {
  EXPECT_EQ(WrapAngle(std::nextafter(pi, 4.0)), -std::nextafter(pi, 0.0));
  EXPECT_EQ(WrapAngle(std::nextafter(-pi, -4.0)), std::nextafter(pi, 0.0));
  EXPECT_NEAR(WrapAngle(pi + 0.1), -pi + 0.1, 1e-15);
  EXPECT_NEAR(WrapAngle(-pi - 0.1), pi - 0.1, 1e-15);
}

TEST(WrapAngle, TakesManyTurnsInBothDirections) {
  for (const double turns : {1.0, -1.0, 2.0, 17.0, -1000.0, 1e6}) {
    for (const double rad : {0.0, 0.3, -0.3, 3.1, -3.1}) {
      EXPECT_NEAR(WrapAngle(rad + turns * 2.0 * pi), rad, 1e-15 * (1.0 + 8.0 * std::abs(turns)));
    }
  }
}

TEST(WrapAngle, StaysInTheHalfOpenIntervalAtOddMultiplesOfPi) {
  for (int odd = -99; odd <= 99; odd += 2) {
    for (const double rad : {odd * pi, std::nextafter(odd * pi, 1e9), std::nextafter(odd * pi, -1e9)}) {
      EXPECT_GT(WrapAngle(rad), -pi) << odd;
      EXPECT_LE(WrapAngle(rad), pi) << odd;
      EXPECT_NEAR(std::abs(WrapAngle(rad)), pi, 1e-13) << odd;
    }
  }
}

TEST(WrapAngle, LetsNonFiniteAnglesShow) {
  EXPECT_TRUE(std::isnan(WrapAngle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(WrapAngle(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace ariadne::slam
