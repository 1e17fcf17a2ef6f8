#pragma once

#include <array>
#include <vector>

#include "control/approach_step.h"

namespace ariadne::control {

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
/// they are told: under the limits, with exact arcs. Error for gains and options that are none and poses
/// that are not finite.
ApproachResult SimulateApproach(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                                const ApproachOptions& options,
                                ApproachBehaviour behaviour = ApproachBehaviour::kController);

/// What the same approach costs, without its trajectory.
struct ApproachCostResult {
  ApproachStatus status = ApproachStatus::kReached;
  double length = 0.0;    // [m]
  double duration = 0.0;  // [s]
  double turned = 0.0;    // [rad]
};

ApproachCostResult ApproachCost(const slam::Pose2& T_map_robot, const slam::Pose2& T_map_goal,
                                const ApproachOptions& options,
                                ApproachBehaviour behaviour = ApproachBehaviour::kController);

}  // namespace ariadne::control

namespace ariadne {

template <>
struct EnumNames<control::ApproachStatus> {
  static constexpr std::array<std::string_view, 3> value{"reached", "time_out", "left_behind"};
};

}  // namespace ariadne
