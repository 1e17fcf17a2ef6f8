#pragma once

#include <Eigen/Core>

#include "slam/base/options.h"
#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// What the two wheels do alike: roll ways [m], or turn at speeds [m/s] of their rims; forward is positive.
struct WheelPair {
  double left = 0.0;
  double right = 0.0;
};

/// A base on two driven wheels beside each other and passive castors (Sec. 2.1).
struct DriveGeometry {
  double wheel_radius = 0.1;
  double track = 0.5;
  double radius_ratio = 1.0;
  int ticks_per_turn = 4000;

  double MetersPerTick() const;

  /// What wheels that err by their ratio roll while their encoders count so many ticks [m].
  WheelPair WaysOf(double left_ticks, double right_ticks) const;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("wheel_radius", self.wheel_radius, Unit("m"), Range{0.005, 1.0},
          "open in the paper (2.1); wheels of 20 cm fit under a platform of 80 x 60 cm");
    visit("track", self.track, Unit("m"), Range{0.05, 3.0},
          "between the wheels' contact points; open in the paper, 50 cm of the 60 cm width");
    visit(
        "radius_ratio", self.radius_ratio, Unit(""), Range{0.8, 1.25},
        "of the right wheel's radius to the left one's; wheel_radius is their mean. See ariadne calibrate");
    visit("ticks_per_turn", self.ticks_per_turn, Unit(""), Range{1, 1e7},
          "of a wheel; open in the paper, 1000 lines in quadrature are usual: 0.16 mm");
  }
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
