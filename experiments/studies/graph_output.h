#pragma once

#include "experiments/run/run_directory.h"
#include "experiments/studies/optimize_options.h"
#include "slam/graph/optimize/optimize.h"

namespace ariadne::experiments {

/// Writes what an optimization has made of a graph: the file's graph at the poses of the minimum, as .g2o
/// and as a trajectory, pictures, and what the files of the run are.
template <typename Pose>
void WriteOptimizedGraph(const slam::PoseGraph<Pose>& guess, const slam::OptimizeResult<Pose>& minimum,
                         const OptimizeOptions& options, const RunDirectory& run);

}  // namespace ariadne::experiments
