#pragma once

#include <utility>
#include <vector>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// How uncertain the optimized poses are, by the inverse of the Gauss-Newton Hessian, given that the edges'
/// information is right.
template <typename Pose>
struct GraphCovariances {
  std::vector<typename Pose::Square> nodes;  // of T_map_node in its tangent space; zero where fixed
  std::vector<typename Pose::Square> pairs;  // of T_a_b in its tangent space, one per requested pair (a, b)
};

/// `edge_weights` as of OptimizeResult; empty: all one. The pairs need not be joined by edges.
template <typename Pose>
GraphCovariances<Pose> MarginalCovariances(
    const PoseGraph<Pose>& graph, const std::vector<std::pair<std::size_t, std::size_t>>& pairs = {},
    const std::vector<double>& edge_weights = {});

}  // namespace ariadne::slam
