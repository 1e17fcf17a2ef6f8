#pragma once

#include <span>
#include <vector>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// Which edges begin or end at each node, in the order of the edges.
template <typename Pose>
class EdgesAtNodes {
 public:
  explicit EdgesAtNodes(const PoseGraph<Pose>& graph) : begin_(graph.nodes.size() + 1, 0) {
    for (const PoseEdge<Pose>& edge : graph.edges) {
      ++begin_[edge.from + 1];
      ++begin_[edge.to + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    edges_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      edges_[next[graph.edges[i].from]++] = i;
      edges_[next[graph.edges[i].to]++] = i;
    }
  }

  std::span<const std::size_t> Of(std::size_t node) const {
    return {edges_.data() + begin_[node], edges_.data() + begin_[node + 1]};
  }

 private:
  std::vector<std::size_t> begin_;  // of each node's part of edges_
  std::vector<std::size_t> edges_;
};

/// The node at which the edge ends, seen from one of its nodes.
template <typename Pose>
std::size_t OtherEnd(const PoseEdge<Pose>& edge, std::size_t node) {
  return edge.from == node ? edge.to : edge.from;
}

}  // namespace ariadne::slam
