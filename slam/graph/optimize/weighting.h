#pragma once

#include <vector>

#include "slam/graph/kernels.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// How much each edge counts in a descent.
struct EdgeWeighting {
  GraphRobust kernel = GraphRobust::kNone;  // of closures
  double squared_scale = 1.0;               // of the kernel
  std::vector<double> weights = {};         // fixed ones, one per edge; empty: all one

  /// The cost of edge k at its squared error, and by how much its information is scaled.
  template <typename Pose>
  KernelValue operator()(const PoseGraph<Pose>& graph, std::size_t k, double squared_error) const {
    if (!weights.empty()) return {weights[k] * squared_error, weights[k], 0.0};
    if (kernel == GraphRobust::kNone || !IsClosure(graph.edges[k])) return {squared_error, 1.0, 0.0};
    return Evaluate(kernel, squared_error, squared_scale);
  }
};

}  // namespace ariadne::slam
