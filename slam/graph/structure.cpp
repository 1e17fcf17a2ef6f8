#include "slam/graph/structure.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "slam/base/error.h"
#include "slam/graph/edges_at_nodes.h"

namespace ariadne::slam {
namespace {

bool IsFinitePose(const Pose2& pose) { return std::isfinite(pose.angle) && pose.translation.allFinite(); }
bool IsFinitePose(const Pose3& pose) { return IsFinite(pose); }

template <typename Pose>
void CheckNumbers(const PoseGraph<Pose>& graph) {
  for (const PoseNode<Pose>& node : graph.nodes) {
    if (!IsFinitePose(node.T_map_node)) Fail("the pose of vertex {} is NaN or infinite", node.id);
  }
  for (const PoseEdge<Pose>& edge : graph.edges) {
    if (edge.from >= graph.nodes.size() || edge.to >= graph.nodes.size() || edge.from == edge.to)
      Fail("an edge joins nodes {} and {} of {}; it must join two of them", edge.from, edge.to,
           graph.nodes.size());
    if (!IsFinitePose(edge.T_from_to) || !edge.information.allFinite())
      Fail("the edge from vertex {} to {} holds NaN or infinity", graph.nodes[edge.from].id,
           graph.nodes[edge.to].id);
  }
  for (const PosePrior<Pose>& prior : graph.priors) {
    if (prior.node >= graph.nodes.size())
      Fail("a prior is of node {} of {}; there is no such node", prior.node, graph.nodes.size());
    if (!IsFinitePose(prior.T_map_node) || !prior.information.allFinite())
      Fail("the prior of vertex {} holds NaN or infinity", graph.nodes[prior.node].id);
  }
}

}  // namespace

template <typename Pose>
std::vector<std::size_t> FindPieces(const PoseGraph<Pose>& graph) {
  const std::size_t unknown = graph.nodes.size();
  const EdgesAtNodes<Pose> edges(graph);
  std::vector<std::size_t> pieces(graph.nodes.size(), unknown);
  std::size_t count = 0;
  std::vector<std::size_t> reached;
  for (std::size_t first = 0; first < graph.nodes.size(); ++first) {
    if (pieces[first] != unknown) continue;
    pieces[first] = count;
    reached.push_back(first);
    while (!reached.empty()) {
      const std::size_t node = reached.back();
      reached.pop_back();
      for (const std::size_t edge : edges.Of(node)) {
        const std::size_t other = OtherEnd(graph.edges[edge], node);
        if (pieces[other] != unknown) continue;
        pieces[other] = count;
        reached.push_back(other);
      }
    }
    ++count;
  }
  return pieces;
}

template <typename Pose>
void CheckGraph(const PoseGraph<Pose>& graph) {
  if (graph.nodes.empty()) Fail("the graph has no vertices, so that there is nothing to optimize");
  CheckNumbers(graph);
  const std::vector<std::size_t> pieces = FindPieces(graph);
  const auto second = std::ranges::find(pieces, std::size_t{1});
  if (second == pieces.end()) return;
  Fail(
      "the graph is not one piece: no edges lead from vertex {} to vertex {}; optimize its {} pieces alone",
      graph.nodes.front().id, graph.nodes[static_cast<std::size_t>(second - pieces.begin())].id,
      *std::ranges::max_element(pieces) + 1);
}

template <typename Pose>
std::vector<std::size_t> IndefiniteEdges(const PoseGraph<Pose>& graph) {
  std::vector<std::size_t> indefinite;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const Eigen::LLT<typename Pose::Square> factor(graph.edges[i].information);
    if (factor.info() != Eigen::Success) indefinite.push_back(i);
  }
  return indefinite;
}

template std::vector<std::size_t> FindPieces(const PoseGraph2&);
template std::vector<std::size_t> FindPieces(const PoseGraph3&);
template void CheckGraph(const PoseGraph2&);
template void CheckGraph(const PoseGraph3&);
template std::vector<std::size_t> IndefiniteEdges(const PoseGraph2&);
template std::vector<std::size_t> IndefiniteEdges(const PoseGraph3&);

}  // namespace ariadne::slam
