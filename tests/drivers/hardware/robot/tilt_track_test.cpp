#include "drivers/hardware/robot/tilt_track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

constexpr double kStep = 2.0 * M_PI / 4096.0;  // of the servo [rad]

double Rounded(double angle) { return std::round(angle / kStep) * kStep; }

TEST(TiltTrack, IsOnTheLineOfAnEvenMotion) {
  TiltTrack track(0.1);
  for (int i = 0; i < 20; ++i) track.Add(5.0 + 0.01 * i, 0.3 + 1.2 * 0.01 * i);
  for (const double time : {4.99, 5.0, 5.087, 5.19, 5.2}) {
    EXPECT_NEAR(track.At(time).angle, 0.3 + 1.2 * (time - 5.0), 1e-12);
    EXPECT_NEAR(track.At(time).rate, 1.2, 1e-9);
  }
}

/// A line through many steps errs less than one through two.
TEST(TiltTrack, SmoothsTheStepsOfTheServo) {
  TiltTrack wide(0.1), narrow(0.0);
  for (int i = 0; i < 200; ++i) {
    const double time = 0.0137 * i;
    wide.Add(time, Rounded(1.2 * time));
    narrow.Add(time, Rounded(1.2 * time));
  }
  double wide_square = 0.0, narrow_square = 0.0;
  for (int i = 100; i < 2000; ++i) {
    const double time = 0.00123 * i;
    wide_square += std::pow(wide.At(time).angle - 1.2 * time, 2);
    narrow_square += std::pow(narrow.At(time).angle - 1.2 * time, 2);
  }
  EXPECT_LT(std::sqrt(wide_square / 1900.0), 0.15 * kStep);
  EXPECT_LT(wide_square, 0.5 * narrow_square);
}

TEST(TiltTrack, NeedsTwoMoments) {
  TiltTrack track(0.1);
  track.Add(1.0, 0.2);
  track.Add(1.0, 0.3);
  EXPECT_THAT(ErrorOf([&] { track.At(1.0); }), testing::HasSubstr("measured 1 times"));
}

}  // namespace
}  // namespace ariadne::drivers
