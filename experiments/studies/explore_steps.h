#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/mission/mission.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// A step of a mission, as a run keeps it in steps/stepNNN.json: what was known after a scan, and what was
/// planned from there.
struct ExploredStep {
  std::size_t index = 0;                        // of the scan
  bool registered = true;                       // it was
  std::vector<slam::Pose2> T_map_stops;         // of all scans up to this, as they lay then
  std::vector<Eigen::Vector2d> driven_map;      // from the stop before to this one
  std::vector<planning::LabelledPolygon> area;  // at the first height
  std::vector<Eigen::Vector2d> obstacles_map;   // not in the file
  std::optional<planning::View> view;           // the next one; none at the end, and on ways back
  std::vector<slam::Pose2> planned_map;         // the way there; empty at the end
  bool leg_only = false;                        // the way ends before the view
  bool of_disc = false;

  const slam::Pose2& T_map_base() const { return T_map_stops.back(); }
};

/// The steps of a mission as it goes: each when its scan is registered, and again with what is planned from
/// there.
class MissionSteps {
 public:
  const ExploredStep& OnStop(const MissionStop& stop, const MissionMap& map);
  const ExploredStep& OnPlan(const PlannedDrive& drive, const Surroundings& around);
  /// The last step then shows what is known in the end.
  const ExploredStep& OnEnd(const MissionResult& result);

  const ExploredStep& step() const { return step_; }
  const std::vector<Eigen::Vector2d>& driven_map() const { return driven_map_; }  // so far

 private:
  ExploredStep step_;
  std::vector<Eigen::Vector2d> driven_map_;
};

/// "steps/step007", to which the kind of file is added.
std::string StepName(std::size_t index);

/// Places to a tenth of a millimetre.
Json ToJson(const ExploredStep& step);

/// Error with the name for what ToJson has not written.
ExploredStep StepFromJson(const Json& json, const std::string& name);

/// All steps of a run of `explore`, in their order. Error where it has none.
std::vector<ExploredStep> ReadSteps(const std::filesystem::path& run);

}  // namespace ariadne::experiments
