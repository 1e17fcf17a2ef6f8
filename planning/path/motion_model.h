#pragma once

// Includes OMPL: for .cpp files only.

#include <ompl/base/MotionValidator.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <memory>
#include <vector>

#include "planning/path/plan_path.h"

namespace ariadne::planning::internal {

/// How a robot gets from one pose to another where nothing is in the way.
class MotionModel {
 public:
  MotionModel(const FreeSpace& space, const PathOptions& options);

  const std::shared_ptr<ompl::base::SE2StateSpace>& state_space() const { return state_space_; }

  /// Poses on the motion from one to another, without the first; none of which moves any corner of the
  /// robot, or the robot's frame, by more than a step [m].
  std::vector<slam::Pose2> BetweenByCorners(const slam::Pose2& from, const slam::Pose2& to,
                                            double step) const;
  std::vector<slam::Pose2> BetweenByFrame(const slam::Pose2& from, const slam::Pose2& to,
                                          double step) const;

 private:
  std::vector<slam::Pose2> Straight(const slam::Pose2& from, const slam::Pose2& to, int count) const;

  PathModel model_;
  double turning_radius_, reach_;
  std::shared_ptr<ompl::base::SE2StateSpace> state_space_;
};

/// Whether the robot's rectangle is free on the way, its start aside; looked at as often as PlanPath says.
bool IsMotionFree(const FreeSpace& space, const Footprint& footprint, const MotionModel& model,
                  const slam::Pose2& from, const slam::Pose2& to);

/// The same, for OMPL.
class RectangleMotions : public ompl::base::MotionValidator {
 public:
  RectangleMotions(const ompl::base::SpaceInformationPtr& info, const FreeSpace& space,
                   const Footprint& footprint, const MotionModel& model);
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to) const override;
  bool checkMotion(const ompl::base::State* from, const ompl::base::State* to,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  const FreeSpace& space_;
  const Footprint& footprint_;
  const MotionModel& model_;
};

}  // namespace ariadne::planning::internal
