#pragma once

#include "experiments/run/progress_display.h"
#include "experiments/run/scan_source.h"
#include "experiments/studies/register_log.h"
#include "experiments/studies/register_options.h"

namespace ariadne::experiments {

/// Writes the tables of the log, the poses in the forms that other programs read, the map of all points,
/// and pictures. Returns the scans at their poses, thinned for views of the map; none where options.output
/// wants no figures.
std::vector<slam::PosedCloud> WriteRegisterOutput(const RegisterOptions& options, const ScanSource& source,
                                                  const RegisterLog& log, const RunDirectory& run,
                                                  ProgressDisplay& progress);

}  // namespace ariadne::experiments
