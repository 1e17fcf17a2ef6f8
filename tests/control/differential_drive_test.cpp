#include "control/differential_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr double kTrack = 0.5;

double Difference(const Pose2& a, const Pose2& b) { return (a.Inverse() * b).Log().norm(); }

/// The arc in extended precision, from the textbook: radius s / a, and a straight line for a = 0.
Pose2 ArcInLongDouble(const WheelPair& ways) {
  const long double s = (static_cast<long double>(ways.left) + ways.right) / 2;
  const long double a = (static_cast<long double>(ways.right) - ways.left) / kTrack;
  if (a == 0) return {0.0, {static_cast<double>(s), 0.0}};
  const long double half_sine = std::sin(a / 2);
  return {
      static_cast<double>(a),
      {static_cast<double>(s * std::sin(a) / a), static_cast<double>(s * 2 * half_sine * half_sine / a)}};
}

/// Turns on both sides of every threshold between "straight" and "arc", and far from them.
std::vector<double> Turns() {
  std::vector<double> turns{0.0, 1e-300, 1e-12, 1e-6, 0.3, 1.5, 3.0};
  for (const double threshold : {1e-3, 0.02}) {
    for (const double factor : {0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0})
      turns.push_back(factor * threshold);
  }
  const std::size_t count = turns.size();
  for (std::size_t i = 0; i < count; ++i) turns.push_back(-turns[i]);
  return turns;
}

TEST(DifferentialDrive, SplitsSpeedOntoTheWheels) {
  const WheelPair left_curve = WheelsOf(0.4, 0.2, kTrack);
  EXPECT_DOUBLE_EQ(left_curve.left, 0.35);
  EXPECT_DOUBLE_EQ(left_curve.right, 0.45);
}

TEST(DifferentialDrive, RollsAQuarterCircle) {
  const double turn = std::numbers::pi / 2;
  const Pose2 quarter = RollArc(WheelsOf(2.0 * turn, turn, kTrack), kTrack);  // of radius 2 m
  EXPECT_LT(Difference(quarter, {turn, {2.0, 2.0}}), 1e-14);
}

TEST(DifferentialDrive, TurnsOnTheSpot) {
  const Pose2 turned = RollArc({-0.1, 0.1}, kTrack);
  EXPECT_EQ(turned.translation.norm(), 0.0);
  EXPECT_DOUBLE_EQ(turned.angle, 0.4);
}

TEST(DifferentialDrive, RollsExactlyOnBothSidesOfStraight) {
  for (const double turn : Turns()) {
    for (const double way : {0.0, 1e-4, 0.7, -0.7}) {
      const WheelPair ways = WheelsOf(way, turn, kTrack);
      EXPECT_LT(Difference(RollArc(ways, kTrack), ArcInLongDouble(ways)), 5e-16) << way << " m " << turn;
    }
  }
}

TEST(DifferentialDrive, HasTheJacobianOfItsDifferences) {
  constexpr double kStep = 1e-6;
  for (const double turn : Turns()) {
    for (const double way : {0.0, 0.7, -0.7}) {
      const WheelPair ways = WheelsOf(way, turn, kTrack);
      const Pose2 back = RollArc(ways, kTrack).Inverse();
      Eigen::Matrix<double, 3, 2> differences;
      const auto moved = [&](double left, double right) {
        return (back * RollArc({ways.left + left, ways.right + right}, kTrack)).Log();
      };
      differences.col(0) = (moved(kStep, 0.0) - moved(-kStep, 0.0)) / (2.0 * kStep);
      differences.col(1) = (moved(0.0, kStep) - moved(0.0, -kStep)) / (2.0 * kStep);
      const Eigen::Matrix<double, 3, 2> J = RollArcJacobian(ways, kTrack);
      EXPECT_LT((J - differences).cwiseAbs().maxCoeff(), 1e-9) << way << " m " << turn;
    }
  }
}

TEST(DifferentialDrive, HasNoJumpOfTheJacobianAtTheThreshold) {
  const auto at = [](double turn) { return RollArcJacobian(WheelsOf(0.7, turn, kTrack), kTrack); };
  for (const double threshold : {1e-3, 0.02}) {
    const Eigen::Matrix<double, 3, 2> jump = at(threshold * (1.0 + 1e-14)) - at(threshold * (1.0 - 1e-14));
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), 2e-14);
  }
}

}  // namespace
}  // namespace ariadne::control
