#pragma once

#include <string>
#include <vector>

#include "experiments/metrics/bootstrap.h"
#include "experiments/report/table.h"
#include "experiments/studies/matching_trial.h"

namespace ariadne::experiments {

/// A trial with what tells it from others.
struct LabelledTrial {
  double noise = 1.0;
  int seed = 0;
  std::string method;
  MatchingTrial trial;
};

/// A row per trial, without times.
Table TrialTable(const std::vector<LabelledTrial>& trials);

/// Per noise level and method the medians over the seeds with their confidence intervals.
Table MedianTable(const std::vector<LabelledTrial>& trials, const BootstrapOptions& bootstrap);

/// Per noise level, each other method against `reference` on the same seeds: median difference with its
/// interval, and the p-value of Wilcoxon's signed-rank test, adjusted over the rows after Holm. "truth" and
/// "odometry" are no methods and left out.
Table PairedTable(const std::vector<LabelledTrial>& trials, const std::string& reference,
                  const BootstrapOptions& bootstrap);

Json ToJson(const LabelledTrial& trial);
LabelledTrial LabelledTrialFromJson(const Json& json);

}  // namespace ariadne::experiments
