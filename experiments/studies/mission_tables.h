#pragma once

#include <vector>

#include "experiments/metrics/bootstrap.h"
#include "experiments/report/table.h"
#include "experiments/studies/mission_trial.h"

namespace ariadne::experiments {

/// A row per way, over all worlds and seeds: medians, with intervals for what it took to get to the target;
/// "-" where most did not get there.
Table MissionVariantTable(const std::vector<MissionTrial>& trials, double target,
                          const BootstrapOptions& bootstrap);

/// A row per world and way: medians over the seeds, the least that a run covered and the worst of its
/// poses, and means of what should not happen.
Table MissionWorldTable(const std::vector<MissionTrial>& trials, double target);

/// Against the first way, in pairs of the same world and seed: mean differences. Where the target was not
/// reached, `penalty` scans count, the most that were allowed: the least that it can have been.
Table MissionDifferenceTable(const std::vector<MissionTrial>& trials, double penalty,
                             const BootstrapOptions& bootstrap);

}  // namespace ariadne::experiments
