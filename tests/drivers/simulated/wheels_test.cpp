#include "drivers/simulated/wheels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using slam::Pose2;

constexpr double kStep = 0.01;  // [s]
using std::numbers::pi;

WheelsOptions WheelsWithoutErrors() {
  WheelsOptions options;
  options.radius_spread = options.track_spread = options.slip = 0.0;
  return options;
}

/// Where the robot is, and believes to be, after a motion of the test.
struct Driver {
  explicit Driver(const WheelsOptions& options, std::uint64_t seed = 1) : wheels({}, options, seed) {
    odometry.Update(wheels.Ticks());
  }

  void Step() {
    const WheelStep step = wheels.Accelerate(kStep);
    truth = truth * wheels.Motion(step, 1.0);
    wheels.Turn(step, 1.0);
    odometry.Update(wheels.Ticks());
  }

  /// The way is velocity times duration: what accelerating loses, braking adds.
  void Go(const Velocity& velocity, double duration) {
    wheels.Command(velocity);
    for (int i = 0; i < std::lround(duration / kStep); ++i) Step();
    wheels.Command({});
    while (!wheels.idle()) Step();
  }

  /// Four sides of 4 m, with turns of 90 deg (UMBmark: Borenstein and Feng 1996).
  void DriveSquare(double direction) {
    for (int side = 0; side < 4; ++side) {
      Go({0.5, 0.0}, 8.0);
      Go({0.0, direction * pi / 4.0}, 2.0);
    }
  }

  Pose2 error() const { return odometry.odometry().T_odom_base.Inverse() * truth; }

  Wheels wheels;
  control::WheelOdometry odometry{{}, {}};
  Pose2 truth;
};

TEST(Wheels, WithoutErrorsDoWhatTheOdometryBelieves) {
  for (const double direction : {1.0, -1.0}) {
    Driver driver(WheelsWithoutErrors());
    driver.DriveSquare(direction);
    EXPECT_LT(driver.truth.Log().norm(), 1e-9) << "back at the start";
    EXPECT_LT(driver.error().Log().norm(), 0.005) << "but for the rounding to ticks of 0.16 mm";
  }
}

TEST(Wheels, ThatAreFurtherApartTurnTooLittleBothWays) {
  WheelsOptions options = WheelsWithoutErrors();
  options.track_error = 0.01;
  const double corner = pi / 2.0 / 1.01;
  for (const double direction : {1.0, -1.0}) {
    Driver driver(options);
    driver.DriveSquare(direction);
    Pose2 expected;
    for (int side = 0; side < 4; ++side) {
      expected = expected * Pose2{0.0, {4.0, 0.0}} * Pose2{direction * corner, {0.0, 0.0}};
    }
    EXPECT_LT((expected.Inverse() * driver.truth).Log().norm(), 1e-9);
    EXPECT_NEAR(driver.error().angle, -direction * 4.0 * (pi / 2.0 - corner), 2e-3);
  }
}

TEST(Wheels, OfUnequalRadiusCurveTheSameWayInBothSquares) {
  WheelsOptions options = WheelsWithoutErrors();
  options.left_radius_error = -0.002;
  options.right_radius_error = 0.002;
  const double curve = 4.0 * 0.004 / control::DriveGeometry().track;  // of a side, to the left [rad]
  for (const double direction : {1.0, -1.0}) {
    Driver driver(options);
    driver.DriveSquare(direction);
    Pose2 expected;
    for (int side = 0; side < 4; ++side) {
      // While turning on the spot the larger wheel pulls the middle along its own way.
      const double turn = direction * pi / 2.0;
      const double pull = 0.5 * 0.004 * 0.5 * control::DriveGeometry().track * turn;
      expected = expected * Pose2::Exp({4.0, 0.0, curve}) * Pose2::Exp({pull, 0.0, turn});
    }
    EXPECT_LT((expected.Inverse() * driver.truth).Log().norm(), 1e-9);
    EXPECT_NEAR(driver.error().angle, 4.0 * curve, 2e-3);
  }
}

TEST(Wheels, KeepTheLimits) {
  const WheelsOptions options = WheelsWithoutErrors();
  Wheels wheels({}, options, 1);
  RandomStream stream = NamedStream(1, "wheels_test/commands");
  Velocity before;
  for (int i = 0; i < 5000; ++i) {
    if (i % 50 == 0) wheels.Command({DrawUniform(stream, -2.0, 2.0), DrawUniform(stream, -3.0, 3.0)});
    wheels.Accelerate(kStep);
    const Velocity now = wheels.velocity();
    EXPECT_LE(std::abs(now.forward), options.max_speed + 1e-12);
    EXPECT_LE(std::abs(now.turning), options.max_turning + 1e-12);
    EXPECT_LE(std::abs(now.forward - before.forward), options.acceleration * kStep + 1e-12);
    EXPECT_LE(std::abs(now.turning - before.turning), options.turning_acceleration * kStep + 1e-12);
    before = now;
  }
}

TEST(Wheels, KeepTheCurveOfACommandBeyondTheLimits) {
  Wheels wheels({}, WheelsWithoutErrors(), 1);
  wheels.Command({1.6, -0.5});
  for (int i = 0; i < 300; ++i) wheels.Accelerate(kStep);
  EXPECT_DOUBLE_EQ(wheels.velocity().forward, 0.8);
  EXPECT_DOUBLE_EQ(wheels.velocity().turning, -0.25);
}

TEST(Wheels, CountWholeTicksAndBackwardsBelowZero) {
  Driver driver(WheelsWithoutErrors());
  driver.Go({-0.1, 0.0}, 10.0);
  const double meters_per_tick = control::DriveGeometry().MetersPerTick();
  const std::int32_t ticks = control::TicksSince(0, driver.wheels.Ticks().left);
  EXPECT_EQ(ticks, static_cast<std::int32_t>(std::floor(-1.0 / meters_per_tick)));
}

TEST(Wheels, SlipAsAsked) {
  WheelsOptions options = WheelsWithoutErrors();
  options.slip = 0.004;
  constexpr int kSteps = 4000;
  Wheels wheels({}, options, 3);
  wheels.Command({0.5, 0.5});
  double chi_square = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const WheelStep step = wheels.Accelerate(kStep);
    const double left = step.rolled.left - step.encoded.left,
                 right = step.rolled.right - step.encoded.right;
    const double q = options.slip * options.slip;
    chi_square += left * left / (q * step.encoded.left) + right * right / (q * step.encoded.right);
  }
  EXPECT_NEAR(chi_square, 2.0 * kSteps, 4.0 * std::sqrt(4.0 * kSteps));
}

/// The ways over the ground of one test drive.
std::vector<WheelStep> StepsOf(const WheelsOptions& options, std::uint64_t seed = 5) {
  Wheels wheels({}, options, seed);
  wheels.Command({0.4, 0.3});
  std::vector<WheelStep> steps;
  for (int i = 0; i < 50; ++i) steps.push_back(wheels.Accelerate(kStep));
  return steps;
}

TEST(Wheels, DrawEachErrorFromAStreamOfItsOwn) {
  WheelsOptions spread_only;
  spread_only.slip = 0.0;
  WheelsOptions slip_only;
  slip_only.radius_spread = slip_only.track_spread = 0.0;
  const auto both = StepsOf({}), spread = StepsOf(spread_only), slip = StepsOf(slip_only);
  for (std::size_t i = 0; i < both.size(); ++i) {
    EXPECT_NE(spread[i].rolled.left, spread[i].encoded.left);
    const double slip_of_both = both[i].rolled.left - spread[i].rolled.left;
    EXPECT_NEAR(slip_of_both, slip[i].rolled.left - slip[i].encoded.left, 1e-16);
    const double right_slip_of_both = both[i].rolled.right - spread[i].rolled.right;
    EXPECT_NEAR(right_slip_of_both, slip[i].rolled.right - slip[i].encoded.right, 1e-16);
  }
}

TEST(Wheels, KeepTheDrawsWhenTheSizeOfAnErrorChanges) {
  WheelsOptions wider;
  wider.track_spread *= 3.0;
  const auto steps = StepsOf({}), with_wider = StepsOf(wider);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].rolled.left, with_wider[i].rolled.left);
    EXPECT_EQ(steps[i].rolled.right, with_wider[i].rolled.right);
  }
}

TEST(Wheels, DifferFromSeedToSeed) {
  EXPECT_EQ(StepsOf({}, 5)[9].rolled.left, StepsOf({}, 5)[9].rolled.left);
  EXPECT_NE(StepsOf({}, 5)[9].rolled.left, StepsOf({}, 6)[9].rolled.left);
}

TEST(Wheels, StopWhereTheCommandIsNoNumber) {
  Wheels wheels({}, WheelsWithoutErrors(), 1);
  wheels.Command({0.5, 0.0});
  wheels.Accelerate(kStep);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { wheels.Command({nan, 0.0}); }), testing::HasSubstr("cannot turn at nan m/s"));
  EXPECT_TRUE(wheels.idle());
}

}  // namespace
}  // namespace ariadne::drivers
