#pragma once

#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// Ends a run: writes report.html, which shows what the directory holds (its pictures, metrics.json, every
/// table, and links to all files), and then progress.json, which says that the `total` steps are finished.
/// Times are left to timing.json, so that the page is the same from run to run.
void FinishRun(const RunDirectory& run, const std::string& title, std::size_t total);

}  // namespace ariadne::experiments
