#pragma once

#include <vector>

#include "slam/geometry/pose2.h"

namespace ariadne::control {

enum class LegKind { kForward, kBackward, kTurn };

/// A part of a path on which the robot moves in one way: it stands at its begin and at its end, at the
/// cusps, the corners and the turns in place of the path.
struct PathLeg {
  LegKind kind = LegKind::kForward;
  std::size_t first = 0, last = 0;  // poses of the path; what follows begins at `last`
  double length = 0.0;              // [m]; of a turn [rad], positive to the left
};

/// The leg that begins at pose `first` of a path of poses T_map_robot; without length at its last pose.
/// Poses between which nothing moves count for nothing. A corner is where the direction of motion jumps
/// by more than `corner` [rad].
PathLeg LegFrom(const std::vector<slam::Pose2>& path, std::size_t first, double corner);

/// All legs of a path.
std::vector<PathLeg> LegsOf(const std::vector<slam::Pose2>& path, double corner);

/// A leg that is driven, by the way along it. Between two poses it is an arc where their headings say so,
/// and else a straight line.
class DrivenLeg {
 public:
  /// The path must outlive the leg.
  DrivenLeg(const std::vector<slam::Pose2>& path, const PathLeg& leg);

  double length() const { return ways_.back(); }

  /// Where the frame is after a way [m], with the angle of the direction it moves in, which is opposite to
  /// the heading on the way back. Beyond its ends the leg goes on straight.
  slam::Pose2 MotionAt(double way) const;

  /// The way [m] between `from` and `to` after which the leg is nearest to a place.
  double NearestWay(const Eigen::Vector2d& p_map, double from, double to) const;

 private:
  const std::vector<slam::Pose2>& path_;
  PathLeg leg_;
  std::vector<double> ways_;  // to each of its poses, along chords
};

}  // namespace ariadne::control
