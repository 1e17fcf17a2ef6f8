#pragma once

#include <array>

#include "slam/geometry/pose2.h"

namespace ariadne::planning {

/// The shortest way forward from one pose to another with a least turning radius: three pieces, arcs or a
/// straight line (Dubins 1957; formulas of Shkel, Lumelsky 2001).
///
/// OMPL's own DubinsStateSpace ends the program by an assertion for poses for which a square root of 0 is
/// rounded below it: 1 in 40,000 random pairs 10 m apart, and pairs 1e-6 m apart.
class DubinsWay {
 public:
  /// The radius [m] must be positive, the poses finite.
  DubinsWay(const slam::Pose2& T_map_from, const slam::Pose2& T_map_to, double turning_radius);

  double length() const { return radius_ * (lengths_[0] + lengths_[1] + lengths_[2]); }  // [m]

  /// The pose at share s of the length, 0 to 1; at 1 it is the goal to 1e-6.
  slam::Pose2 At(double s) const;

  /// +1 left, -1 right, 0 straight.
  const std::array<int, 3>& turns() const { return turns_; }

 private:
  slam::Pose2 T_map_from_;
  double radius_;
  std::array<int, 3> turns_{};
  std::array<double, 3> lengths_{};  // by the radius
};

}  // namespace ariadne::planning
