#pragma once

#include "experiments/mission/mission.h"
#include "experiments/run/progress_display.h"
#include "experiments/studies/model_output.h"

namespace ariadne::experiments {

/// The scans of a mission that could be registered, with their points within the range of the mapper.
std::vector<slam::PosedCloud> ModelScans(const MissionResult& result, const slam::ScanFilterOptions& range);

/// The last of the six steps (Sec. 6.2): all scans become one model.
BuildingModel IntegrateScans(const std::vector<slam::PosedCloud>& scans, const ModelOptions& options);

/// Integrates what a mission has seen, and writes it as `ariadne map` does, with model.json for its counts
/// and a README.txt for the whole run.
BuildingModel WriteExploredModel(const MissionResult& result, const slam::ScanFilterOptions& range,
                                 const ModelOptions& options, const RunDirectory& run,
                                 ProgressDisplay& progress);

}  // namespace ariadne::experiments
