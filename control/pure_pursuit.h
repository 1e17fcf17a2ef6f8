#pragma once

#include <vector>

#include "control/drive_limits.h"
#include "control/simulate_approach.h"
#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// How a path is followed.
struct FollowOptions {
  DriveLimits limits;
  double period = 0.05;
  double lookahead_time = 0.6;
  double lookahead = 0.12;
  double braking = 0.8;
  double turn_first = 35.0;
  double corner = 40.0;
  double end_distance = 0.002;
  double goal_angle = 0.25;
  double max_time = 600.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("limits", self.limits, "what the motors can do");
    visit("period", self.period, Unit("s"), Range{1e-4, 1.0}, "of control");
    visit("lookahead_time", self.lookahead_time, Unit("s"), Range{0.0, 10.0},
          "the robot heads for where the path is after this time; longer: smoother, and it cuts curves");
    visit("lookahead", self.lookahead, Unit("m"), Range{0.01, 10.0},
          "at least; 0.12 keeps it within 1 cm of arcs of 0.3 m");
    visit("braking", self.braking, Unit("share"), Range{0.05, 1.0},
          "of the acceleration that is planned with, before curves and ends; the rest is for errors");
    visit("turn_first", self.turn_first, Unit("deg"), Range{1.0, 179.0},
          "where the path leads off by more, the robot stops and turns in place before it drives");
    visit("corner", self.corner, Unit("deg"), Range{1.0, 179.0},
          "jumps of the path's direction by more are corners, where the robot stops and turns in place");
    visit("end_distance", self.end_distance, Unit("m"), Range{1e-6, 1.0},
          "before the end of a part of the path, where it ends");
    visit("goal_angle", self.goal_angle, Unit("deg"), Range{1e-6, 180.0}, "where turning ends");
    visit("max_time", self.max_time, Unit("s"), Range{0.0, 1e6}, "after which a simulation gives up");
  }
};

/// How far a robot has come on a path. It never goes back.
struct PathProgress {
  std::size_t leg = 0;   // the pose of the path where the leg begins that it is on
  double passed = 0.0;   // of this leg [m]; of a turn [rad], to the left
  bool turning = false;  // in place, towards where the path leads
  DriveCommand command;  // the one before; set it where the robot was told something else
};

struct FollowStep {
  DriveCommand command;   // for the next period, within the limits
  PathProgress progress;  // to be handed in with the next pose
  bool finished = false;  // stands, turned as the last pose, beside or at it
};

/// What to do next on a path of poses T_map_robot, which holds what a differential drive does: arcs and
/// lines forward, arcs and lines backward, turns in place, or lines with headings along them. Regulated
/// pure pursuit (Macenski et al. 2023, after Coulter 1992): it heads for a place of the path ahead, on the
/// curve that leads there, slower where the path's curves ahead, their changes, or the end of a leg demand
/// it. Legs end at cusps and corners; there the robot stands. In the end it turns as the last pose.
///
/// It starts with PathProgress{}. Where the robot was pushed off the path it comes back to it, as far as
/// the leg is long; what remains at the end remains. Error for a path without poses or with one that is not
/// finite, for a progress beyond it, and for options out of their range.
FollowStep FollowPath(const std::vector<slam::Pose2>& path, const slam::Pose2& T_map_robot,
                      const PathProgress& progress, const FollowOptions& options);

/// How the robot would follow the path, from standing, if nothing were in its way and its motors did as
/// they are told; kReached or kTimeOut. One sample per period, start and end included.
ApproachResult SimulateFollowing(const std::vector<slam::Pose2>& path, const slam::Pose2& T_map_robot,
                                 const FollowOptions& options);

}  // namespace ariadne::control
