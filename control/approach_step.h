#pragma once

#include <array>

#include "control/drive_limits.h"
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

/// The controller as it is, and the two behaviours that are tried where something is in its way (Sec. 5.2).
enum class ApproachBehaviour {
  kController,        // the law of Sec. 5.1
  kTurnFirst,         // turn in place towards the goal's place, then the law: no large radii
  kTurnStraightTurn,  // turn towards the goal's place, drive there straight, turn
};

enum class ApproachPhase { kStart, kDrive, kFinalTurn };

/// How far an approach has come.
struct ApproachProgress {
  ApproachPhase phase = ApproachPhase::kStart;
  DriveCommand command;  // the one before; set it where the robot was told something else
};

struct ApproachStep {
  DriveCommand command;       // for the next period, within the limits
  ApproachProgress progress;  // to be handed in with the next pose
  bool finished = false;      // stands
};

/// What to do next on the way to a goal. It starts with ApproachProgress{}. Options are not checked, nor
/// are max_time and max_excursion watched: it is called millions of times.
ApproachStep StepApproach(const slam::Pose2& T_goal_robot, const ApproachProgress& progress,
                          ApproachBehaviour behaviour, const ApproachOptions& options);

}  // namespace ariadne::control

namespace ariadne {

template <>
struct EnumNames<control::ApproachBehaviour> {
  static constexpr std::array<std::string_view, 3> value{"controller", "turn_first", "turn_straight_turn"};
};

}  // namespace ariadne
