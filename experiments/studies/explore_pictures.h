#pragma once

#include "experiments/studies/explore_steps.h"
#include "slam/geometry/drawing.h"

namespace ariadne::experiments {

/// A step from above, in the map, with its legend: what is known to be free with its seen and unseen edges,
/// what stands in the way, the way so far with its numbered stops, the next view and the planned way.
slam::Drawing DrawingOf(const ExploredStep& step, std::span<const Eigen::Vector2d> driven_map);

/// The steps of a run for its page: one picture, and a slider that changes it.
std::string StepsHtml(std::size_t count);

/// Keeps what a mission knows and plans in the run, step by step, as it goes: steps/stepNNN.json and .svg.
/// A step is written when its scan is registered, and again with what is planned from there.
class StepKeeper {
 public:
  /// Keeps a reference.
  explicit StepKeeper(const RunDirectory& run) : run_(run) {}

  void OnStop(const MissionStop& stop, const MissionMap& map) { Write(steps_.OnStop(stop, map)); }
  void OnPlan(const PlannedDrive& drive, const Surroundings& around) {
    Write(steps_.OnPlan(drive, around));
  }
  void OnEnd(const MissionResult& result) { Write(steps_.OnEnd(result)); }

 private:
  void Write(const ExploredStep& step) const;

  const RunDirectory& run_;
  MissionSteps steps_;
};

}  // namespace ariadne::experiments
