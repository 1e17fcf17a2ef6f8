#include <queue>

#include "slam/graph/edges_at_nodes.h"
#include "slam/graph/structure.h"

namespace ariadne::slam {
namespace {

/// Poses that grow along edges.
template <typename Pose>
class Placement {
 public:
  explicit Placement(PoseGraph<Pose>& graph)
      : graph_(graph), edges_(graph), placed_(graph.nodes.size(), false) {}

  void StartFrom(std::size_t node) {
    placed_[node] = true;
    odometry_.push(node);
  }

  void Run() {
    // A pose along odometry is better than one across a closure, so these wait until odometry ends.
    while (true) {
      if (!odometry_.empty()) {
        FollowOdometry();
      } else if (!closures_.empty()) {
        FollowOneClosure();
      } else {
        return;
      }
    }
  }

 private:
  void FollowOdometry() {
    const std::size_t node = odometry_.front();
    odometry_.pop();
    for (const std::size_t edge : edges_.Of(node)) {
      if (!IsClosure(graph_.edges[edge])) Follow(graph_.edges[edge], node);
    }
    closures_.push(node);
  }

  void FollowOneClosure() {
    const std::size_t node = closures_.front();
    const std::span<const std::size_t> edges = edges_.Of(node);
    if (next_closure_ == edges.size()) {
      closures_.pop();
      next_closure_ = 0;
    } else {
      Follow(graph_.edges[edges[next_closure_++]], node);
    }
  }

  void Follow(const PoseEdge<Pose>& edge, std::size_t node) {
    const std::size_t other = OtherEnd(edge, node);
    if (placed_[other]) return;
    const Pose T_node_other = edge.from == node ? edge.T_from_to : edge.T_from_to.Inverse();
    graph_.nodes[other].T_map_node = graph_.nodes[node].T_map_node * T_node_other;
    StartFrom(other);
  }

  PoseGraph<Pose>& graph_;
  EdgesAtNodes<Pose> edges_;
  std::vector<bool> placed_;
  std::queue<std::size_t> odometry_;  // placed, edges to successive nodes not yet followed
  std::queue<std::size_t> closures_;  // placed, the other edges not yet all followed
  std::size_t next_closure_ = 0;      // among the edges of the first of closures_
};

}  // namespace

template <typename Pose>
void PlaceAlongEdges(PoseGraph<Pose>& graph) {
  if (graph.nodes.empty()) return;
  Placement<Pose> placement(graph);
  bool anchored = false;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (!graph.nodes[i].fixed) continue;
    placement.StartFrom(i);
    anchored = true;
  }
  if (!anchored) placement.StartFrom(0);
  placement.Run();
}

template void PlaceAlongEdges(PoseGraph2&);
template void PlaceAlongEdges(PoseGraph3&);

}  // namespace ariadne::slam
