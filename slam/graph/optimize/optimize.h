#pragma once

#include <functional>
#include <string>
#include <vector>

#include "slam/graph/graph_options.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

enum class GraphStatus {
  kConverged,
  kIterationLimit,
  kFailed,  // no finite minimum was found: an information matrix is indefinite, or numbers overflow
};

std::string_view Name(GraphStatus status);

/// One step of a descent.
struct GraphIteration {
  double objective = 0.0;  // before the step, with the kernel and the weights of its time
  double step = 0.0;       // length of the largest step of a node (m and rad together)
  double damping = 0.0;    // 0: a plain Gauss-Newton step
  int factorizations = 0;  // that it took
};

/// Where the time went [s]; the only part of a result that is not deterministic.
struct GraphTimes {
  double start = 0.0;      // initialization
  double symbolic = 0.0;   // ordering and symbolic factorization
  double linearize = 0.0;  // errors and derivatives
  double factorize = 0.0;
  double solve = 0.0;
  double total = 0.0;
};

template <typename Pose>
struct OptimizeResult {
  GraphStatus status = GraphStatus::kFailed;
  std::string message;               // the status as a sentence, with numbers
  PoseGraph<Pose> graph;             // with the optimized poses
  double objective_guess = 0.0;      // Objective() at the given poses
  double objective_start = 0.0;      // after the initialization
  double objective = 0.0;            // at the end; without kernel and weights
  std::vector<double> edge_weights;  // robust: in [0, 1], one per edge; else empty
  std::vector<GraphIteration> iterations;
  GraphTimes times;
};

/// Finds the poses that make the objective small. Fixed nodes stay; where there are none and no prior, the
/// first node stays. Error where the graph is not one piece (CheckConnected).
template <typename Pose>
OptimizeResult<Pose> Optimize(PoseGraph<Pose> graph, const GraphOptions& options,
                              const std::function<void(const GraphIteration&)>& on_iteration = {});

}  // namespace ariadne::slam
