#include "control/approach_plan.h"

namespace ariadne::control {

ApproachPlan PlanApproach(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                          const GroundObstacles& obstacles, const ApproachPlanOptions& options) {
  ApproachPlan plan;
  for (const ApproachBehaviour behaviour : {ApproachBehaviour::kController, ApproachBehaviour::kTurnFirst,
                                            ApproachBehaviour::kTurnStraightTurn}) {
    plan.trajectory = SimulateApproach(T_map_robot, T_map_goal, options.approach, behaviour);
    plan.poses = ResamplePath(plan.trajectory.samples, options.sampling);
    plan.attempts.push_back(
        {behaviour, plan.trajectory.status, FirstHit(options.robot, plan.poses, obstacles)});
    if (plan.IsFree()) break;
  }
  return plan;
}

}  // namespace ariadne::control
