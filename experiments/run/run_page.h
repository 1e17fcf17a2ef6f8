#pragma once

#include <optional>

#include "experiments/report/page.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// Ends a run: writes report.html, which shows what the directory holds (its pictures, metrics.json, every
/// table, and links to all files), and then progress.json, which says that the `total` steps are finished.
/// Times are left to timing.json, so that the page is the same from run to run. `first` is a section of the
/// run's own, for the top of the page, such as ViewerSection.
void FinishRun(const RunDirectory& run, const std::string& title, std::size_t total,
               const std::optional<PageSection>& first = {});

}  // namespace ariadne::experiments
