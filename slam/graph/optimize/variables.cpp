#include "slam/graph/optimize/variables.h"

namespace ariadne::slam {

template <typename Pose>
GraphVariables FindVariables(const PoseGraph<Pose>& graph) {
  bool anchored = !graph.priors.empty();
  for (const PoseNode<Pose>& node : graph.nodes) anchored = anchored || node.fixed;
  GraphVariables variables;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const bool held = graph.nodes[i].fixed || (!anchored && i == 0);
    variables.of_node.push_back(held ? GraphVariables::kFixed : variables.node_of.size());
    if (!held) variables.node_of.push_back(i);
  }
  for (const PoseEdge<Pose>& edge : graph.edges) {
    const std::size_t from = variables.of_node[edge.from], to = variables.of_node[edge.to];
    if (from != GraphVariables::kFixed && to != GraphVariables::kFixed)
      variables.places.emplace_back(from, to);
  }
  variables.order = OrderBlocks(variables.node_of.size(), variables.places);
  return variables;
}

template GraphVariables FindVariables(const PoseGraph2&);
template GraphVariables FindVariables(const PoseGraph3&);

}  // namespace ariadne::slam
