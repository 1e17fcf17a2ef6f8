#pragma once

#include <span>

#include "experiments/metrics/bootstrap.h"
#include "experiments/report/table.h"
#include "experiments/studies/nbv_trials.h"

namespace ariadne::experiments {

/// What tables tell of a floor.
struct NbvFloorSummary {
  std::string name;
  double reachable_area = 0.0;   // [m^2]
  double wall_length = 0.0;      // that can be seen [m]
  std::size_t fewest_views = 0;  // that were found
  int lower_bound = 0;           // fewer are impossible
};

/// Every trial in a row, for machines.
Table NbvTrialTable(std::span<const NbvTrial> trials);

/// The floors: their size, the fewest views, and a tour through them.
Table NbvFloorTable(std::span<const NbvTrial> trials, std::span<const NbvFloorSummary> floors);

/// One row for each variant of a study: medians over floors of the median over the seeds of a floor, with
/// intervals (`never` where the share was not reached, which counts as infinite), and the difference from
/// `default` as paired by floor, with Wilcoxon's test after Holm.
Table NbvStudyTable(std::span<const NbvTrial> trials, const std::string& study,
                    const BootstrapOptions& bootstrap);

/// Share covered after multiples of the bound's scans and of its tour, mean over floors and seeds.
Table NbvCurveTable(std::span<const NbvTrial> trials);

/// Planning: not deterministic [ms].
Table NbvTimeTable(std::span<const NbvTrial> trials);

}  // namespace ariadne::experiments
