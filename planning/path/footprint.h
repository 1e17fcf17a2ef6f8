#pragma once

#include <Eigen/Core>
#include <vector>

#include "planning/path/free_space.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

struct FootprintOptions {
  double length = 0.8;
  double width = 0.6;
  double centre_ahead = 0.0;
  double margin = 0.05;
  double smallest = 0.06;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.01, 10.0}, "Kurt3D with its scanner (Sec. 2.1)");
    visit("width", self.width, Unit("m"), Range{0.01, 10.0}, "across, wheels included");
    visit("centre_ahead", self.centre_ahead, Unit("m"), Range{-10.0, 10.0},
          "of the rectangle, before the robot's frame, which lies between the driven wheels");
    visit("margin", self.margin, Unit("m"), Range{0.0, 10.0},
          "around the rectangle: the pose's error, the controller's, and what lies between two poses");
    visit("smallest", self.smallest, Unit("m"), Range{0.005, 10.0},
          "part of the rectangle that is looked at by itself, as a disc, which stands out by 0.21 of it");
  }
};

/// A robot's rectangle. It is free where the disc around it is, or else where both its halves are.
class Footprint {
 public:
  /// Error for options out of their range.
  explicit Footprint(const FootprintOptions& options = {});

  /// Whether the robot, and its margin around it, lies within the area. Where it says so it is so; it may
  /// say no to a place that leaves less than 0.21 smallest, and 2.5 cm where the margin is below 0.71
  /// cells.
  bool IsFree(const FreeSpace& space, const slam::Pose2& T_map_robot) const;

  /// The same for a robot whose heading is known by its direction.
  bool IsFree(const FreeSpace& space, const Eigen::Vector2d& p_map, const Eigen::Vector2d& heading) const;

  /// Of the rectangle, counterclockwise, without the margin.
  std::vector<Eigen::Vector2d> CornersAt(const slam::Pose2& T_map_robot) const;

  /// Of the rectangle [m].
  Eigen::Vector2d CentreAt(const slam::Pose2& T_map_robot) const {
    return T_map_robot * Eigen::Vector2d(options_.centre_ahead, 0.0);
  }

  /// From the robot's frame to the farthest corner: what turning moves [m].
  double reach() const { return reach_; }

  /// Of a disc within the rectangle, with the margin: what no way can be narrower than [m].
  double least_radius() const;

  const FootprintOptions& options() const { return options_; }

 private:
  FootprintOptions options_;
  double reach_;
};

}  // namespace ariadne::planning
