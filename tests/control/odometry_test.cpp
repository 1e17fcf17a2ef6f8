#include "control/odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

const double kDefaultTrack = DriveGeometry().track;

/// A tick is a millimetre.
DriveGeometry Millimeters() {
  DriveGeometry geometry;
  geometry.ticks_per_turn = 100;
  geometry.wheel_radius = 0.1 / (2.0 * std::numbers::pi);
  return geometry;
}

WheelTicks TicksOf(const DriveGeometry& geometry, double left, double right) {
  return {static_cast<std::uint32_t>(std::llround(left / geometry.MetersPerTick())),
          static_cast<std::uint32_t>(std::llround(right / geometry.MetersPerTick()))};
}

/// Steps of the wheels on an eight of two circles with a straight line between them.
std::vector<WheelPair> Tour() {
  std::vector<WheelPair> steps;
  const auto drive = [&](int count, double forward, double turning) {
    for (int i = 0; i < count; ++i) steps.push_back(WheelsOf(forward, turning, DriveGeometry().track));
  };
  drive(100, 0.03, 0.04);
  drive(60, 0.05, 0.0);
  drive(100, 0.03, -0.04);
  drive(30, 0.0, 0.05);
  drive(20, -0.03, 0.01);
  return steps;
}

/// One seed: the wheels roll as the encoders say, times their constant errors, plus slip.
double NormalizedErrorOfATour(const OdometryOptions& options, std::uint64_t seed) {
  const DriveGeometry geometry;
  RandomStream errors = NamedStream(seed, "test/errors"), slip = NamedStream(seed, "test/slip");
  const double left_scale = DrawNormal(errors, 1.0, options.radius_uncertainty);
  const double right_scale = DrawNormal(errors, 1.0, options.radius_uncertainty);
  const double true_track = geometry.track * DrawNormal(errors, 1.0, options.track_uncertainty);
  WheelOdometry odometry(geometry, options);
  odometry.Update({});
  Pose2 truth;
  WheelPair encoded;
  for (const WheelPair& step : Tour()) {
    encoded = {encoded.left + step.left, encoded.right + step.right};
    odometry.Update(TicksOf(geometry, encoded.left, encoded.right));
    const double left_slip = DrawNormal(slip, 0.0, options.wheel_noise * std::sqrt(std::abs(step.left)));
    const double right_slip = DrawNormal(slip, 0.0, options.wheel_noise * std::sqrt(std::abs(step.right)));
    truth = truth * RollArc({step.left * left_scale + left_slip, step.right * right_scale + right_slip},
                            true_track);
  }
  const Eigen::Vector3d error = (odometry.odometry().T_odom_base.Inverse() * truth).Log();
  return error.dot(odometry.odometry().covariance.ldlt().solve(error));
}

void ExpectHonestCovariance(const OdometryOptions& options) {
  constexpr int kSeeds = 400;
  double sum = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) sum += NormalizedErrorOfATour(options, 1 + seed);
  const double dof = 3.0 * kSeeds;
  EXPECT_NEAR(sum, dof, 3.0 * std::sqrt(2.0 * dof)) << "chi-square, three sigma";
}

TEST(TicksSince, CountsAcrossTheWrap) {
  constexpr std::uint32_t kMax = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(TicksSince(kMax, 0), 1);
  EXPECT_EQ(TicksSince(0, kMax), -1);
  EXPECT_EQ(TicksSince(kMax - 5, 10), 16);
  EXPECT_EQ(TicksSince(10, kMax - 5), -16);
  const auto most = static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(TicksSince(most, most + 1), 1) << "signed counters wrap here";
}

TEST(WheelOdometry, StandsAtTheOriginWhateverTheCountersStartFrom) {
  WheelOdometry odometry(Millimeters(), {});
  odometry.Update({123456789, 4000000000});
  EXPECT_EQ(odometry.odometry().T_odom_base.translation.norm(), 0.0);
  EXPECT_EQ(odometry.odometry().covariance.norm(), 0.0);
  odometry.Update({123456789 + 500, 4000000000 + 500});
  EXPECT_NEAR(odometry.odometry().T_odom_base.translation.x(), 0.5, 1e-12);
  EXPECT_GT(odometry.odometry().covariance(0, 0), 0.0);
}

TEST(WheelOdometry, DoesNotNoticeTheWrap) {
  for (const std::uint32_t start : {0xffffff00u, 0x7fffff00u}) {
    WheelOdometry wrapped(Millimeters(), {}), plain(Millimeters(), {});
    wrapped.Update({start, start});
    plain.Update({0, 0});
    for (std::uint32_t i = 1; i <= 100; ++i) {
      wrapped.Update({start + 7 * i, start + 9 * i});
      plain.Update({7 * i, 9 * i});
    }
    EXPECT_EQ(wrapped.odometry().T_odom_base.translation, plain.odometry().T_odom_base.translation);
    EXPECT_EQ(wrapped.odometry().T_odom_base.angle, plain.odometry().T_odom_base.angle);
    EXPECT_EQ(wrapped.odometry().covariance, plain.odometry().covariance);
  }
}

TEST(WheelOdometry, ReturnsToTheStartOfACircle) {
  WheelOdometry odometry(Millimeters(), {});
  odometry.Update({});
  const WheelPair step = WheelsOf(0.01, 0.01, Millimeters().track);  // radius 1 m
  for (int i = 1; i <= 628; ++i) odometry.Update(TicksOf(Millimeters(), i * step.left, i * step.right));
  EXPECT_LT(odometry.odometry().T_odom_base.translation.norm(), 0.02);
}

TEST(WheelOdometry, GrowsTheSlipOfAStraightLineAsInTheTextbook) {
  OdometryOptions options;
  options.radius_uncertainty = options.track_uncertainty = 0.0;
  WheelOdometry odometry(Millimeters(), options);
  odometry.Update({});
  constexpr int kWay = 4000;  // [mm]
  for (std::uint32_t i = 1; i <= kWay; ++i) odometry.Update({i, i});
  const double way = 0.001 * kWay, q = options.wheel_noise * options.wheel_noise;
  const double heading = 2.0 * q * way / (kDefaultTrack * kDefaultTrack);
  const Eigen::Matrix3d& P = odometry.odometry().covariance;
  EXPECT_NEAR(P(0, 0), 0.5 * q * way, 1e-12);
  EXPECT_NEAR(P(2, 2), heading, 1e-12);
  EXPECT_NEAR(P(1, 1), heading * way * way / 3.0, 1e-3 * P(1, 1)) << "heading's random walk, integrated";
  EXPECT_NEAR(P(1, 2), heading * way / 2.0, 1e-3 * P(1, 2));
}

TEST(WheelOdometry, GrowsTheEffectOfTheRadiiWithTheWay) {
  OdometryOptions options;
  options.wheel_noise = 0.0;
  WheelOdometry odometry(Millimeters(), options);
  odometry.Update({});
  for (std::uint32_t i = 1; i <= 2000; ++i) odometry.Update({i, i});
  const double heading_sigma = std::sqrt(odometry.odometry().covariance(2, 2));
  EXPECT_NEAR(heading_sigma, std::sqrt(2.0) * options.radius_uncertainty * 2.0 / kDefaultTrack, 1e-9);
}

TEST(WheelOdometry, GivesTheSameCovarianceForFineAndCoarseSteps) {
  WheelOdometry fine(Millimeters(), {}), coarse(Millimeters(), {});
  fine.Update({});
  coarse.Update({});
  for (std::uint32_t i = 1; i <= 1000; ++i) {
    fine.Update({3 * i, 4 * i});
    if (i % 20 == 0) coarse.Update({3 * i, 4 * i});
  }
  const Eigen::Matrix3d difference = fine.odometry().covariance - coarse.odometry().covariance;
  EXPECT_LT(difference.norm(), 1e-3 * fine.odometry().covariance.norm());
}

TEST(WheelOdometry, IsHonestAboutSlip) {
  OdometryOptions options;
  options.radius_uncertainty = options.track_uncertainty = 0.0;
  ExpectHonestCovariance(options);
}

TEST(WheelOdometry, IsHonestAboutRadiiAndTrack) {
  OdometryOptions options;
  options.wheel_noise = 0.0;
  ExpectHonestCovariance(options);
}

TEST(WheelOdometry, IsHonestAboutAllTogether) { ExpectHonestCovariance({}); }

/// A right wheel that is 2 % larger, which the odometry knows: it drives an arc where both count alike.
TEST(WheelOdometry, KnowsUnequalWheels) {
  DriveGeometry geometry;
  geometry.radius_ratio = 1.02;
  const WheelPair ways = geometry.WaysOf(1000.0, 1000.0);
  EXPECT_NEAR(ways.right / ways.left, 1.02, 1e-12);
  EXPECT_NEAR(0.5 * (ways.left + ways.right), 1000.0 * geometry.MetersPerTick(), 1e-12);
  WheelOdometry odometry(geometry, {});
  odometry.Update({0, 0});
  const slam::Odometry& moved = odometry.Update({1000, 1000});
  EXPECT_NEAR(moved.T_odom_base.angle, (ways.right - ways.left) / geometry.track, 1e-12);
}

TEST(WheelOdometry, RefusesOptionsOutOfRange) {
  DriveGeometry geometry;
  geometry.track = 0.0;
  EXPECT_THAT(ErrorOf([&] { WheelOdometry odometry(geometry, {}); }),
              testing::HasSubstr("drive.track is 0 m"));
  OdometryOptions options;
  options.wheel_noise = -1.0;
  EXPECT_THAT(ErrorOf([&] { WheelOdometry odometry({}, options); }),
              testing::HasSubstr("odometry.wheel_noise"));
}

}  // namespace
}  // namespace ariadne::control
