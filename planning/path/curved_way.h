#pragma once

#include <vector>

#include "slam/geometry/pose2.h"

namespace ariadne::planning {

/// A piece of a way: along a circle of the turning radius, or straight.
struct WayPiece {
  int turn = 0;         // +1 left, -1 right, 0 straight
  double length = 0.0;  // by the radius; negative backward
};

/// A way of arcs of one radius and of straight lines.
class CurvedWay {
 public:
  CurvedWay(const slam::Pose2& T_map_from, double turning_radius, std::vector<WayPiece> pieces);

  double length() const { return radius_ * length_; }  // backward pieces count as forward ones [m]

  /// The pose at share s of the length, 0 to 1.
  slam::Pose2 At(double s) const;

  /// Poses at most a step [m] from each other, those between two pieces included, without the first.
  std::vector<slam::Pose2> Sampled(double step) const;

  const std::vector<WayPiece>& pieces() const { return pieces_; }

 private:
  slam::Pose2 T_map_from_;
  double radius_, length_ = 0.0;
  std::vector<WayPiece> pieces_;
};

/// The shortest way forward from one pose to another: three pieces (Dubins 1957; formulas of Shkel,
/// Lumelsky 2001). It arrives within 2e-5 m. The radius [m] must be positive, the poses finite.
///
/// OMPL's own DubinsStateSpace ends the program by an assertion for poses for which a square root of 0 is
/// rounded below it: 1 in 40,000 random pairs 10 m apart, and most pairs 1e-6 m apart.
CurvedWay DubinsWay(const slam::Pose2& T_map_from, const slam::Pose2& T_map_to, double turning_radius);

}  // namespace ariadne::planning
