#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// What the two wheels do alike: roll ways [m], or turn at speeds [m/s] of their rims; forward is positive.
struct WheelPair {
  double left = 0.0;
  double right = 0.0;
};

/// The rim speeds of a base that drives at `forward` [m/s] and turns counterclockwise at `turning` [rad/s]:
/// v_R,L = u +- omega b / 2 (Sec. 5.1). With ways instead of speeds, the ways.
WheelPair WheelsOf(double forward, double turning, double track);

/// How the base, midway between wheels `track` [m] apart, moves while they roll: on an arc, exactly, as
/// long as the ratio of their speeds is constant. T_before_after.
slam::Pose2 RollArc(const WheelPair& ways, double track);

/// RollArc(ways + d) = RollArc(ways) * Exp(J d) for small d = (left, right) [m].
Eigen::Matrix<double, 3, 2> RollArcJacobian(const WheelPair& ways, double track);

}  // namespace ariadne::control
