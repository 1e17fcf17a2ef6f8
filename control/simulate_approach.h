#pragma once

#include <array>
#include <vector>

#include "control/indiveri.h"

namespace ariadne::control {

/// How an approach is controlled, and when it ends.
struct ApproachOptions {
  IndiveriOptions law;
  DriveLimits limits;
  double period = 0.05;
  double goal_distance = 0.01;
  bool final_turn = true;
  double goal_angle = 0.25;
  double max_time = 600.0;
  double max_excursion = 20.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("law", self.law, "gains of the controller");
    visit("limits", self.limits, "what the motors can do");
    visit(
        "period", self.period, Unit("s"), Range{1e-4, 1.0},
        "of control; open in the paper. The way of one period is a fraction gamma period of the distance");
    visit("goal_distance", self.goal_distance, Unit("m"), Range{1e-6, 10.0},
          "where driving ends; open in the paper. The law is singular at the goal itself");
    visit("final_turn", self.final_turn, "turn in place afterwards; a separate primitive in the paper");
    visit("goal_angle", self.goal_angle, Unit("deg"), Range{1e-6, 180.0}, "where turning ends");
    visit("max_time", self.max_time, Unit("s"), Range{0.0, 1e6}, "after which the goal is given up");
    visit(
        "max_excursion", self.max_excursion, Unit("m"), Range{0.0, 1e6},
        "farther from the goal than at the start; beyond, the goal is given up. Driving forward only, the "
        "robot must leave a goal behind it before it can turn to it");
  }
};

enum class ApproachStatus { kReached, kTimeOut, kLeftBehind };

/// A moment of a trajectory.
struct ApproachSample {
  double time = 0.0;  // since the start [s]
  slam::Pose2 T_map_robot;
  DriveCommand command;  // until the next sample; the motion in between is one arc
};

struct ApproachResult {
  ApproachStatus status = ApproachStatus::kReached;
  std::vector<ApproachSample> samples;  // one per period, start and end included
  double length = 0.0;                  // of the path [m]
  double duration = 0.0;                // [s]
  double turned = 0.0;                  // sum of all turns, left and right, the one in place included [rad]
};

/// How the robot would drive to the goal, from standing, if nothing were in its way and its motors did as
/// they are told: the law of Sec. 5.1 under the limits, with exact arcs. Error for gains and options that
/// are none and poses that are not finite.
ApproachResult SimulateApproach(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                                const ApproachOptions& options);

/// What the same approach costs, without its trajectory.
struct ApproachCostResult {
  ApproachStatus status = ApproachStatus::kReached;
  double length = 0.0;    // [m]
  double duration = 0.0;  // [s]
  double turned = 0.0;    // [rad]
};

ApproachCostResult ApproachCost(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                                const ApproachOptions& options);

}  // namespace ariadne::control

namespace ariadne {

template <>
struct EnumNames<control::ApproachStatus> {
  static constexpr std::array<std::string_view, 3> value{"reached", "time_out", "left_behind"};
};

}  // namespace ariadne
