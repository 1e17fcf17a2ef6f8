#pragma once

#include <vector>

#include "slam/graph/pose_graph.h"
#include "slam/sparse/block_matrix.h"

namespace ariadne::slam {

/// Which nodes of a graph are to be found, and in which order they are eliminated.
struct GraphVariables {
  static constexpr std::size_t kFixed = static_cast<std::size_t>(-1);

  std::vector<std::size_t> of_node;  // the variable of each node, or kFixed
  std::vector<std::size_t> node_of;  // and back
  std::vector<BlockPlace> places;    // the variables that edges couple
  BlockOrder order;
};

/// Fixed nodes are no variables. Where nothing says where the graph lies in the map, no fixed node and no
/// prior, the first node is held (the gauge).
template <typename Pose>
GraphVariables FindVariables(const PoseGraph<Pose>& graph);

}  // namespace ariadne::slam
