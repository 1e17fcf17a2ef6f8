#include "control/drive_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/random.h"

namespace ariadne::control {
namespace {

TEST(DriveLimits, KeepTheCurve) {
  RandomStream stream = NamedStream(1, "test/limits");
  DriveLimits limits;
  limits.max_wheel_speed = 0.9;
  int wheels_bound = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const DriveCommand wanted{DrawUniform(stream, 0.0, 2.0), DrawUniform(stream, -3.0, 3.0)};
    const DriveCommand command = Saturated(wanted, limits);
    const double wheel = std::abs(command.forward) + 0.25 * std::abs(command.turning);
    EXPECT_NEAR(command.turning * wanted.forward, command.forward * wanted.turning, 1e-12);
    EXPECT_LE(command.forward, 0.8 + 1e-12);
    EXPECT_LE(std::abs(command.turning), 1.0 + 1e-12);
    EXPECT_LE(wheel, 0.9 + 1e-12);
    const double share = std::max({command.forward / 0.8, std::abs(command.turning), wheel / 0.9});
    if (wanted.forward <= 0.8) continue;
    EXPECT_NEAR(share, 1.0, 1e-12) << "not slower than need be";
    wheels_bound += wheel > 0.9 - 1e-12 ? 1 : 0;
  }
  EXPECT_GT(wheels_bound, 10);
}

TEST(DriveLimits, LeaveWhatIsWithinThemAlone) {
  const DriveCommand command = Saturated({0.5, -0.7}, {});
  EXPECT_EQ(command.forward, 0.5);
  EXPECT_EQ(command.turning, -0.7);
  EXPECT_EQ(Saturated({}, {}).forward, 0.0);
}

TEST(DriveLimits, HoldFromEachPeriodToTheNext) {
  RandomStream stream = NamedStream(2, "test/limits");
  const DriveLimits limits;
  DriveCommand before;
  for (int trial = 0; trial < 10000; ++trial) {
    // Now and then something else is wanted.
    const double forward = trial % 50 < 25 ? DrawUniform(stream, 0.0, 2.0) : 0.3;
    const DriveCommand wanted{forward, DrawUniform(stream, -2.0, 2.0)};
    const DriveCommand command = Limited(wanted, before, 0.05, limits);
    ASSERT_LE(std::abs(command.forward - before.forward), 0.5 * 0.05 + 1e-12);
    ASSERT_LE(std::abs(command.turning - before.turning), 1.0 * 0.05 + 1e-12);
    ASSERT_LE(command.forward, 0.8 + 1e-12);
    ASSERT_GE(command.forward, 0.0);
    ASSERT_LE(std::abs(command.turning), 1.0 + 1e-12);
    before = command;
  }
}

TEST(DriveLimits, StartOnTheCurve) {
  const DriveCommand command = Limited({0.8, 0.8}, {}, 0.05, {});
  EXPECT_DOUBLE_EQ(command.forward, 0.025);
  EXPECT_DOUBLE_EQ(command.turning, 0.025);
}

TEST(DriveLimits, BrakeOnTheCurve) {
  // The brakes allow 0.775 m/s at least; the curve then asks for more turning than wanted at 0.4 m/s.
  const DriveCommand command = Limited({0.4, 0.2}, {0.8, 0.4}, 0.05, {});
  EXPECT_DOUBLE_EQ(command.forward, 0.775);
  EXPECT_DOUBLE_EQ(command.turning, 0.3875);
}

TEST(DriveLimits, SlowDownWhereTurningCannotFollow) {
  const DriveCommand command = Limited({0.4, 0.8}, {0.4, 0.0}, 0.05, {});
  EXPECT_DOUBLE_EQ(command.forward, 0.375);
  EXPECT_DOUBLE_EQ(command.turning, 0.05);
}

}  // namespace
}  // namespace ariadne::control
