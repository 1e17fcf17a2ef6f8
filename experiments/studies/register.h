#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/register_options.h"
#include "experiments/studies/register_report.h"

namespace ariadne::experiments {

/// Registers scan by scan, with a checkpoint after each, and fills the run directory (its README.txt says
/// with what). A run that was killed goes on where its last checkpoint is.
RegisterSummary RunRegister(const RegisterOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress);

/// The resolved config of a run: everything that makes it what it is.
std::string RegisterConfig(const RegisterOptions& options);

}  // namespace ariadne::experiments
