#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam/graph/graph_options.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// By which library Ceres factorizes its sparse matrices.
enum class CeresLibrary { kSuiteSparse, kEigen, kCxSparse };

/// How Ceres is run, beyond the options of the graph. The defaults are the fastest of what was measured
/// (experiments/bench/graph_bench.cpp); the rest is there to be measured against.
struct CeresTuning {
  CeresLibrary library = CeresLibrary::kSuiteSparse;
  double initial_trust_region_radius = 1e16;  // Ceres' own: 1e4
  /// The place of each node in the order of elimination; empty: Ceres' own, approximate minimum degree.
  std::vector<std::int32_t> order = {};
};

enum class CeresStatus { kConverged, kIterationLimit, kFailed };

template <typename Pose>
struct CeresResult {
  CeresStatus status = CeresStatus::kFailed;
  std::string message;               // why it ended, in the words of Ceres
  std::vector<Pose> poses;           // T_map_node, one per node
  std::vector<double> edge_weights;  // robust: in [0, 1], one per edge; else empty
  std::vector<double> objectives;    // with kernel or switches; at the start and after each iteration
  double objective = 0.0;            // Objective() of the poses: without them
  int factorizations = 0;
  double linear_solver_seconds = 0.0;  // not deterministic
  double total_seconds = 0.0;          // not deterministic
};

/// Makes the objective of the graph small with Ceres, starting at the nodes' poses. Fixed nodes stay; where
/// there are none and no prior, the first node stays. Of the options, solver, start and threads are not
/// looked at. Kernels and switches apply to closures (IsClosure) alone; of gnc only its kernel, truncated
/// least squares, without graduation. Error where an information matrix is not positive semidefinite.
template <typename Pose>
CeresResult<Pose> OptimizeWithCeres(const PoseGraph<Pose>& graph, const GraphOptions& options,
                                    const CeresTuning& tuning = {});

}  // namespace ariadne::slam
