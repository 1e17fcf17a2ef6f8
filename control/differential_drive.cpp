#include "control/differential_drive.h"

#include <cmath>
#include <numbers>

namespace ariadne::control {
namespace {

/// Below this turn the series is exact to rounding, and the closed form loses digits to cancellation.
constexpr double kStraight = 0.02;  // [rad]

struct Arc {
  double length = 0.0;  // [m]
  double turn = 0.0;    // [rad]
};

Arc ArcOf(const WheelPair& ways, double track) {
  return {0.5 * (ways.left + ways.right), (ways.right - ways.left) / track};
}

/// The columns for (length, turn) of the right Jacobian of SE(2) at the tangent (length, 0, turn):
/// Exp(tau + d) = Exp(tau) * Exp(J d), Sola et al., A micro Lie theory (2018), (163).
Eigen::Matrix<double, 3, 2> RightJacobian(const Arc& arc) {
  const double a = arc.turn, a2 = a * a;
  const bool straight = std::abs(a) < kStraight;
  const double half_sine = std::sin(0.5 * a);
  const double sinc = straight ? 1.0 - a2 / 6.0 + a2 * a2 / 120.0 : std::sin(a) / a;
  const double versine =  // (1 - cos a) / a^2
      straight ? 0.5 - a2 / 24.0 + a2 * a2 / 720.0 : 2.0 * half_sine * half_sine / a2;
  const double rest =  // (a - sin a) / a^2
      straight ? a * (1.0 / 6.0 - a2 / 120.0 + a2 * a2 / 5040.0) : (a - std::sin(a)) / a2;
  Eigen::Matrix<double, 3, 2> J;
  J << sinc, arc.length * rest,            //
      -a * versine, arc.length * versine,  //
      0.0, 1.0;
  return J;
}

}  // namespace

double DriveGeometry::MetersPerTick() const {
  return 2.0 * std::numbers::pi * wheel_radius / ticks_per_turn;
}

WheelPair DriveGeometry::WaysOf(double left_ticks, double right_ticks) const {
  const double left = 2.0 / (1.0 + radius_ratio);
  const double per_tick = MetersPerTick();
  return {left * per_tick * left_ticks, radius_ratio * left * per_tick * right_ticks};
}

WheelPair WheelsOf(double forward, double turning, double track) {
  return {forward - 0.5 * track * turning, forward + 0.5 * track * turning};
}

slam::Pose2 RollArc(const WheelPair& ways, double track) {
  const Arc arc = ArcOf(ways, track);
  return slam::Pose2::Exp({arc.length, 0.0, arc.turn});
}

Eigen::Matrix<double, 3, 2> RollArcJacobian(const WheelPair& ways, double track) {
  Eigen::Matrix2d arc_of_ways;
  arc_of_ways << 0.5, 0.5, -1.0 / track, 1.0 / track;
  return RightJacobian(ArcOf(ways, track)) * arc_of_ways;
}

}  // namespace ariadne::control
