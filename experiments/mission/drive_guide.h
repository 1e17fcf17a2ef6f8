#pragma once

#include <optional>

#include "experiments/mission/drive_path.h"

namespace ariadne::experiments {

/// What leads a drive to its goal: along the path, or by the paper's controller.
class DriveGuide {
 public:
  DriveGuide(const DriveTask& task, const control::FollowOptions& follow) : task_(task), follow_(follow) {}

  /// For the next period; nothing where the robot has arrived.
  std::optional<control::DriveCommand> Next(const slam::Pose2& T_map_base) {
    if (!task_.approach) {
      const control::FollowStep step = control::FollowPath(task_.path_map, T_map_base, on_path_, follow_);
      on_path_ = step.progress;
      return step.finished ? std::nullopt : std::optional(step.command);
    }
    const ApproachTask& approach = *task_.approach;
    const control::ApproachStep step = control::StepApproach(
        approach.T_map_goal.Inverse() * T_map_base, approaching_, approach.behaviour, approach.options);
    approaching_ = step.progress;
    return step.finished ? std::nullopt : std::optional(step.command);
  }

  /// What the robot was told instead.
  void Note(const control::DriveCommand& command) { on_path_.command = approaching_.command = command; }

 private:
  const DriveTask& task_;
  const control::FollowOptions& follow_;
  control::PathProgress on_path_;
  control::ApproachProgress approaching_;
};

}  // namespace ariadne::experiments
