#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/polygon2.h"
#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// What of the robot can hit something.
struct RectangleOptions {
  double length = 0.8;
  double width = 0.6;
  double centre_ahead = 0.0;
  double margin = 0.05;
  double tolerance = 0.002;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.01, 10.0}, "Kurt3D with its scanner (Sec. 2.1)");
    visit("width", self.width, Unit("m"), Range{0.01, 10.0}, "across, wheels included");
    visit("centre_ahead", self.centre_ahead, Unit("m"), Range{-10.0, 10.0},
          "of the rectangle, before the robot's frame, which lies between the driven wheels");
    visit("margin", self.margin, Unit("m"), Range{0.0, 10.0},
          "on each side of the rectangle; open in the paper");
    visit("tolerance", self.tolerance, Unit("m"), Range{1e-5, 1.0},
          "obstacles that stay clear by less may count as hit, for it is looked no closer between poses");
  }
};

/// What stands on the floor: convex outlines (boxes, objects), in either sense, and single points.
struct GroundObstacles {
  std::vector<slam::Ring> outlines;
  std::vector<Eigen::Vector2d> points;
};

/// The outline of a box around T_map_box.
slam::Ring BoxOutline(const slam::Pose2& T_map_box, double length, double width);

/// The smallest convex outline around points, counterclockwise, without points on its edges.
slam::Ring ConvexOutline(std::vector<Eigen::Vector2d> points);

/// By how much the rectangle with its margin is clear of a point or a convex outline, along the best of the
/// axes that separate them: no more than their distance, at least 0.7 of it; not positive where they meet,
/// and then how deep [m].
double GapTo(const RectangleOptions& robot, const slam::Pose2& T_map_robot, const Eigen::Vector2d& p_map);
double GapTo(const RectangleOptions& robot, const slam::Pose2& T_map_robot, const slam::Ring& outline);

/// The rectangle at a pose, for many points.
class PlacedRectangle {
 public:
  PlacedRectangle(const RectangleOptions& robot, const slam::Pose2& T_map_robot);

  double GapTo(const Eigen::Vector2d& p_map) const;

 private:
  Eigen::Matrix2d R_robot_map_;
  Eigen::Vector2d p_map_robot_, p_robot_centre_, half_;  // [m]
};

/// Half the way of the corner that moves farthest on the arc between two poses: from the pose midway, no
/// point of the rectangle gets farther [m].
double HalfSweep(const RectangleOptions& robot, const slam::Pose2& from, const slam::Pose2& to);

struct SweepHit {
  std::size_t interval = 0;  // between this pose and the next
  double share = 0.0;        // of it that is free
  slam::Pose2 T_map_robot;   // there
  std::size_t obstacle = 0;  // index: outlines, and then points
};

/// Where the rectangle with its margin first hits something on a trajectory of poses T_map_robot, between
/// which it moves on arcs of less than half a turn. Exact at the poses; between them the arc is halved
/// until it is either clear by more than what moves, or moves less than the tolerance: it never overlooks a
/// hit. Error for outlines that are not convex, and poses and places that are not finite.
std::optional<SweepHit> FirstHit(const RectangleOptions& robot, const std::vector<slam::Pose2>& poses,
                                 const GroundObstacles& obstacles);

struct PointTouch {
  double share = 0.0;     // of the arc that is free
  std::size_t point = 0;  // index
};

/// Which of many points the rectangle with its margin first touches on the arc between two poses, as
/// FirstHit does for one, but much faster; nothing is checked. A negative margin makes the rectangle
/// smaller.
std::optional<PointTouch> FirstTouch(const RectangleOptions& robot, const slam::Pose2& from,
                                     const slam::Pose2& to, const std::vector<Eigen::Vector2d>& points);

}  // namespace ariadne::control
