#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/mission/beside_memory.h"
#include "experiments/mission/drive_path.h"

namespace ariadne::experiments {

/// What a robot keeps off while it drives: what its scanners see, saw before it came to be beside the
/// robot, and expect of what moves; and what the map knows.
class DriveSight {
 public:
  /// For a task that begins at a pose; keeps a reference to the task.
  DriveSight(const DriveTask& task, const DriveOptions& options, const slam::Pose2& T_map_base);

  /// In the robot's frame.
  struct Places {
    std::vector<Eigen::Vector2d> points_base;
    std::size_t seen = 0;  // of these, the first ones: by the scanners
  };

  /// Now. `known`: what the map knows counts too.
  Places Look(drivers::Robot& robot, const Localizer& localizer, const drivers::RobotState& state,
              bool known);

  /// How to give way to them: with no more margin than the path has.
  const control::AvoidanceOptions& avoid() const { return avoid_; }

 private:
  void KeepInMind(const slam::Pose2& T_map_base);
  std::vector<Eigen::Vector2d> KnownNearby(const slam::Pose2& T_map_base) const;
  Eigen::Vector2d Nearer(const Eigen::Vector2d& p_base) const;
  std::vector<Eigen::Vector2d> ToCome(std::span<const drivers::SafetySweep> sweeps,
                                      const drivers::RobotState& state, const slam::Pose2& T_map_base);

  const DriveTask& task_;
  const DriveOptions& options_;
  control::AvoidanceOptions avoid_;
  double known_margin_ = 0.0;  // more of it, for what only the map knows, which errs more [m]
  BesideMemory beside_;
  MovingThings moving_;
  std::vector<Eigen::Vector2d> known_map_;
};

}  // namespace ariadne::experiments
