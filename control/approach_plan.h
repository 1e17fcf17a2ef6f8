#pragma once

#include <optional>
#include <vector>

#include "control/resample_path.h"
#include "control/simulate_approach.h"
#include "control/swept_rectangle.h"

namespace ariadne::control {

struct ApproachPlanOptions {
  ApproachOptions approach;
  PathSampling sampling;
  RectangleOptions robot;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("approach", self.approach, "the controller");
    visit("sampling", self.sampling,
          "poses of the trajectory that are tested; between them it is looked too");
    visit("robot", self.robot, "what can hit an obstacle");
  }
};

/// One behaviour that was tried.
struct ApproachAttempt {
  ApproachBehaviour behaviour = ApproachBehaviour::kController;
  ApproachStatus status = ApproachStatus::kReached;
  std::optional<SweepHit> hit;
  bool IsFree() const { return status == ApproachStatus::kReached && !hit; }
};

struct ApproachPlan {
  std::vector<ApproachAttempt> attempts;  // in their order, up to the first that is free, or all
  ApproachResult trajectory;              // of the last attempt, free or not
  std::vector<slam::Pose2> poses;         // T_map_robot along it, on which it was tested
  bool IsFree() const { return !attempts.empty() && attempts.back().IsFree(); }
  ApproachBehaviour behaviour() const { return attempts.back().behaviour; }
};

/// How to drive to a goal among obstacles: the controller as it is; turning towards the goal first; turn,
/// straight, turn (Sec. 5.2). Each is simulated under the limits, and the first that sweeps no obstacle is
/// taken. Where none is free, another goal or a planned path must do. Errors as those of SimulateApproach
/// and FirstHit.
ApproachPlan PlanApproach(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                          const GroundObstacles& obstacles, const ApproachPlanOptions& options);

}  // namespace ariadne::control
