#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/run/progress_display.h"
#include "experiments/studies/optimize_options.h"
#include "slam/graph/optimize/certificate.h"
#include "slam/graph/optimize/optimize.h"
#include "slam/io/g2o.h"

namespace ariadne::experiments {

/// Why an objective of a graph cannot be optimized, as sentences; empty where it can be.
struct GraphObstacles {
  std::string information;
  std::string isotropic;
};

/// Looks at all edges and priors.
template <typename Pose>
GraphObstacles FindObstacles(const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph);

/// Error where the objective that the options ask for, or each of both, cannot be optimized.
void RequireObjective(const slam::G2oFile& file, GraphObjective objective);

/// The minima of a graph's objectives that were asked for and exist: at least one.
template <typename Pose>
struct GraphMinima {
  std::optional<slam::OptimizeResult<Pose>> isotropic;
  std::optional<slam::OptimizeResult<Pose>> information;
  std::optional<slam::Certificate> certificate;  // of the isotropic one
  std::vector<std::string> notes;                // what was left out, and why

  /// The information's, if there is one: it says more about the measurements.
  const slam::OptimizeResult<Pose>& best() const { return information ? *information : *isotropic; }
};

template <typename Pose>
GraphMinima<Pose> FindMinima(const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph,
                             const OptimizeOptions& options, ProgressDisplay& progress);

}  // namespace ariadne::experiments
