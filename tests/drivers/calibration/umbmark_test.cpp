#include "drivers/calibration/umbmark.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

constexpr double kTrack = 0.5;

/// Five squares each way, whose errors scatter.
std::vector<DrivenSquare> Squares(double ratio, double track, double scatter, std::uint64_t seed = 1) {
  RandomStream stream = NamedStream(seed, "squares");
  std::vector<DrivenSquare> squares;
  for (int i = 0; i < 10; ++i) {
    DrivenSquare square{i % 2 == 0, SquareError(i % 2 == 0, ratio, track, 4.0, kTrack)};
    square.error.x() += DrawNormal(stream, 0.0, scatter);
    square.error.y() += DrawNormal(stream, 0.0, scatter);
    squares.push_back(square);
  }
  return squares;
}

/// The signs, from drawings: who turns too little ends behind the start on both ways; who drifts to the
/// left ends ahead counterclockwise, and behind clockwise.
TEST(SquareError, HasTheSignsOfTheDrawings) {
  for (const bool counterclockwise : {true, false})
    EXPECT_LT(SquareError(counterclockwise, 1.0, 1.01, 4.0, kTrack).x(), -0.05);
  EXPECT_GT(SquareError(true, 1.001, 1.0, 4.0, kTrack).x(), 0.03);
  EXPECT_LT(SquareError(false, 1.001, 1.0, 4.0, kTrack).x(), -0.03);
  EXPECT_LT(SquareError(true, 1.0, 1.0, 4.0, kTrack).norm(), 1e-12);
}

/// The formulas as Borenstein and Feng print them (their (7) to (17)) agree to first order.
TEST(CalibrateWheels, AgreesWithTheFormulasOfUmbmark) {
  constexpr double kSide = 4.0;
  const double ratio = 1.002, track = 1.004;
  const Eigen::Vector2d ccw = SquareError(true, ratio, track, kSide, kTrack);
  const Eigen::Vector2d cw = SquareError(false, ratio, track, kSide, kTrack);
  const double alpha = (cw.x() + ccw.x()) / (-4.0 * kSide);
  const double beta = (cw.x() - ccw.x()) / (-4.0 * kSide);
  const double radius = 0.5 * kSide / std::sin(0.5 * beta);
  EXPECT_NEAR((radius + 0.5 * kTrack) / (radius - 0.5 * kTrack), ratio, 2e-4);
  EXPECT_NEAR(0.5 * std::numbers::pi / (0.5 * std::numbers::pi - alpha), track, 4e-4);
}

TEST(CalibrateWheels, FindsWhatTheSquaresWereDrivenWith) {
  control::DriveGeometry driven;
  driven.radius_ratio = 1.01;
  const WheelCalibration result = CalibrateWheels(Squares(0.993, 1.03, 0.0), driven);
  EXPECT_NEAR(result.ratio_factor, 0.993, 1e-9);
  EXPECT_NEAR(result.track_factor, 1.03, 1e-9);
  EXPECT_NEAR(result.geometry.radius_ratio, 1.01 * 0.993, 1e-9);
  EXPECT_NEAR(result.geometry.track, 0.5 * 1.03, 1e-9);
  EXPECT_LT(result.error_after, 1e-6);
  EXPECT_GT(result.error_before, 0.2);
}

TEST(CalibrateWheels, KnowsHowFarItErrs) {
  constexpr int kRobots = 400;
  double nees = 0.0, within = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < kRobots; ++i) {
    const WheelCalibration result =
        CalibrateWheels(Squares(1.004, 0.985, 0.01, static_cast<std::uint64_t>(i)), {});
    const Eigen::Vector2d error(result.ratio_factor - 1.004, result.track_factor - 0.985);
    nees += error.dot(result.covariance.inverse() * error) / kRobots;
    const double sigma = std::sqrt(result.covariance(0, 0));
    within += std::abs(error[0]) < 2.0 * sigma ? 1.0 / kRobots : 0.0;
    sum += error.cwiseQuotient(result.covariance.diagonal().cwiseSqrt()) / kRobots;
  }
  EXPECT_NEAR(nees, 2.0, 0.5);
  EXPECT_NEAR(within, 0.95, 0.04);
  EXPECT_LT(sum.norm(), 0.2);  // no bias
}

TEST(CalibrateWheels, RefusesWhatCannotBe) {
  EXPECT_THAT(ErrorOf([] { CalibrateWheels(Squares(1.1, 1.0, 0.0), {}); }), HasSubstr("not plausible"));
  EXPECT_THAT(ErrorOf([] { CalibrateWheels(Squares(1.0, 1.2, 0.0), {}); }), HasSubstr("drive.track"));
  EXPECT_THAT(ErrorOf([] { CalibrateWheels(Squares(1.0, 1.0, 0.5), {}); }), HasSubstr("m apart"));
  std::vector<DrivenSquare> squares = Squares(1.004, 1.02, 0.001);
  for (DrivenSquare& square : squares) square.error.y() *= -1.0;  // an axis the wrong way
  EXPECT_THAT(ErrorOf([&] { CalibrateWheels(squares, {}); }), HasSubstr("sign"));
  squares.resize(5);
  EXPECT_THAT(ErrorOf([&] { CalibrateWheels(squares, {}); }), HasSubstr("too few"));
}

}  // namespace
}  // namespace ariadne::drivers
