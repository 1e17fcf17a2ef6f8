#include "slam/io/g2o.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "slam/base/error.h"
#include "slam/graph/structure.h"
#include "slam/io/g2o_records.h"

namespace ariadne::slam {
namespace {

/// Makes the graph of the records, which must be of one dimension.
template <typename Pose>
class Assembly {
 public:
  Assembly(std::string name, G2oPoses<Pose> poses) : name_(std::move(name)), poses_(std::move(poses)) {}

  G2oFile Run(const G2oRecords& records) {
    if (poses_.edges.empty()) Fail("{}: holds no edges between poses; there is nothing to optimize", name_);
    AddNodes();
    AddEdges();
    AddFixed(records.fixed);
    AddPriors(records.offsets);
    RequireOnePiece();
    if (poses_.vertices.empty()) PlaceNodes();
    CheckNumbers();
    if (records.skipped > 0) {
      notes_.push_back(fmt::format("records that say nothing of poses are left out: {}", records.skipped));
    }
    return {name_, std::move(graph_), std::move(node_lines_), std::move(edge_lines_), std::move(notes_)};
  }

 private:
  void AddNodes() {
    std::vector<G2oVertex<Pose>>& vertices = poses_.vertices;
    if (vertices.empty()) return AddNodesOfEdges();
    std::ranges::stable_sort(vertices, {}, &G2oVertex<Pose>::id);
    const auto twice = std::ranges::adjacent_find(vertices, {}, &G2oVertex<Pose>::id);
    if (twice != vertices.end()) {
      Fail("{}:{}: vertex {} stands in line {} already; remove one of the two", name_, (twice + 1)->line,
           twice->id, twice->line);
    }
    for (const G2oVertex<Pose>& vertex : vertices) AddNode(vertex.id, vertex.line, vertex.T_map_node);
  }

  void AddNodesOfEdges() {
    std::vector<std::pair<std::int64_t, std::size_t>> ends;  // vertex and line
    for (const G2oEdge<Pose>& edge : poses_.edges) {
      ends.emplace_back(edge.from, edge.line);
      ends.emplace_back(edge.to, edge.line);
    }
    std::ranges::sort(ends);
    for (const auto& [id, line] : ends) {
      if (graph_.nodes.empty() || graph_.nodes.back().id != id) AddNode(id, line, Pose());
    }
  }

  void AddNode(std::int64_t id, std::size_t line, const Pose& T_map_node) {
    graph_.nodes.push_back({id, T_map_node, false});
    node_lines_.push_back(line);
  }

  /// The index of a vertex that a record in a line names.
  std::size_t NodeOf(std::int64_t id, std::size_t line) const {
    const auto found = std::ranges::lower_bound(graph_.nodes, id, {}, &PoseNode<Pose>::id);
    if (found == graph_.nodes.end() || found->id != id) {
      Fail("{}:{}: there is no vertex {} in the file; add it, or remove the line", name_, line, id);
    }
    return static_cast<std::size_t>(found - graph_.nodes.begin());
  }

  void AddEdges() {
    for (const G2oEdge<Pose>& edge : poses_.edges) {
      if (edge.from == edge.to) {
        Fail("{}:{}: the edge joins vertex {} with itself; remove it", name_, edge.line, edge.from);
      }
      graph_.edges.push_back(
          {NodeOf(edge.from, edge.line), NodeOf(edge.to, edge.line), edge.T_from_to, edge.information});
      edge_lines_.push_back(edge.line);
    }
  }

  void AddFixed(const std::vector<G2oFix>& fixed) {
    for (const G2oFix& fix : fixed) graph_.nodes[NodeOf(fix.id, fix.line)].fixed = true;
    if (!fixed.empty() || !poses_.priors.empty()) return;
    notes_.push_back(fmt::format("no vertex is fixed: vertex {} is held", graph_.nodes.front().id));
  }

  void AddPriors(const std::vector<G2oOffset>& offsets) {
    for (const G2oPrior<Pose>& prior : poses_.priors) {
      const std::size_t node = NodeOf(prior.id, prior.line);
      graph_.priors.push_back(AtNode(node, prior, offsets));
    }
    if (moved_priors_ == 0) return;
    notes_.push_back(fmt::format("priors with an offset are moved to their vertices, to first order: {}",
                                 moved_priors_));
  }

  PosePrior<Pose2> AtNode(std::size_t node, const G2oPrior<Pose2>& prior, const std::vector<G2oOffset>&) {
    return {node, prior.T_map_sensor, prior.information};
  }

  PosePrior<Pose3> AtNode(std::size_t node, const G2oPrior<Pose3>& prior,
                          const std::vector<G2oOffset>& offsets) {
    const auto offset = std::ranges::find(offsets, prior.offset, &G2oOffset::id);
    if (offset == offsets.end()) {
      Fail("{}:{}: the prior names PARAMS_SE3OFFSET {}, which is not in the file; add it", name_,
           prior.line, prior.offset);
    }
    const Pose3& T_node_sensor = offset->T_node_sensor;
    if (T_node_sensor.Log().isZero(0.0)) return {node, prior.T_map_sensor, prior.information};
    ++moved_priors_;
    // A small motion tau of the node is Ad^-1 tau at the sensor.
    const Pose3::Square Ad = T_node_sensor.Inverse().Adjoint();
    const Pose3::Square information = Ad.transpose() * prior.information * Ad;
    return {node, prior.T_map_sensor * T_node_sensor.Inverse(),
            0.5 * (information + information.transpose())};
  }

  void RequireOnePiece() const {
    const std::vector<std::size_t> pieces = FindPieces(graph_);
    const auto second = std::ranges::find(pieces, std::size_t{1});
    if (second == pieces.end()) return;
    const auto first = static_cast<std::size_t>(second - pieces.begin());
    Fail(
        "{}:{}: no edges lead from vertex {} to vertex {}, which begins a piece of {} of the {} vertices; "
        "{}",
        name_, node_lines_[first], graph_.nodes.front().id, graph_.nodes[first].id,
        std::ranges::count(pieces, std::size_t{1}), pieces.size(),
        "optimize the pieces as files of their own");
  }

  /// Of numbers that were read from the file one by one, products may still be too large.
  void CheckNumbers() const {
    try {
      CheckGraph(graph_);
    } catch (const Error& error) {
      Fail("{}: {}; its numbers are too large to compute with", name_, error.what());
    }
  }

  void PlaceNodes() {
    const auto fixed = std::ranges::count(graph_.nodes, true, &PoseNode<Pose>::fixed);
    if (fixed > 1)
      Fail("{}: {} vertices are fixed, but the file has no vertices to say where", name_, fixed);
    PlaceAlongEdges(graph_);
    notes_.emplace_back("no vertices in the file: placed along the edges");
    if (fixed > 0 || graph_.priors.empty()) return;
    const PosePrior<Pose>& prior = graph_.priors.front();
    const Pose T_map_placed = prior.T_map_node * graph_.nodes[prior.node].T_map_node.Inverse();
    for (PoseNode<Pose>& node : graph_.nodes) node.T_map_node = T_map_placed * node.T_map_node;
  }

  std::string name_;
  G2oPoses<Pose> poses_;
  PoseGraph<Pose> graph_;
  std::vector<std::size_t> node_lines_;
  std::vector<std::size_t> edge_lines_;
  std::vector<std::string> notes_;
  std::size_t moved_priors_ = 0;
};

}  // namespace

G2oFile ReadG2o(std::istream& in, const std::string& name) {
  G2oRecords records = ReadG2oRecords(in, name);
  if (records.in_space) return Assembly<Pose3>(name, std::move(records.space)).Run(records);
  return Assembly<Pose2>(name, std::move(records.plane)).Run(records);
}

}  // namespace ariadne::slam
