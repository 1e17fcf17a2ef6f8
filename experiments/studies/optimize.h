#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/optimize_options.h"

namespace ariadne::experiments {

/// How an optimization has ended.
struct OptimizeSummary {
  std::string text;     // to print: costs, times, certificate, worst edges
  std::string problem;  // a sentence where no minimum was found; else empty
};

/// Error where the file cannot be read, or the objective that is asked for does not exist.
void CheckOptimizeInput(const OptimizeOptions& options);

/// Optimizes a graph and fills the run directory.
OptimizeSummary RunOptimize(const OptimizeOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress);

}  // namespace ariadne::experiments
