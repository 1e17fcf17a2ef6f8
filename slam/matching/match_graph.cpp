#include "slam/matching/match_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "slam/graph/optimize/optimize.h"
#include "slam/matching/loop_closure.h"

namespace ariadne::slam {
namespace {

/// The new scan lies where it belongs, up to less than the gate: the wide gate of a start is not needed.
AlignOptions NearOptions(AlignOptions align) {
  align.start_distance = 0.0;
  align.search_radius = 0.0;
  return align;
}

/// Aligns the new scan, one by one, to those that overlap it most where it lies now.
void AddEdges(const MatchContext& c, MatchResult& result) {
  const std::size_t scan = c.map.scans.size() - 1;
  const AlignOptions near = NearOptions(c.align);
  std::vector<Overlap> overlaps = FindOverlaps(c);
  const auto count = static_cast<std::size_t>(1 + c.match.graph.further_edges);
  if (overlaps.size() > count) overlaps.resize(count);
  for (const Overlap& overlap : overlaps) {
    if (!IsEnough(c, overlap)) break;
    MatchStep step = AlignToUnion(c, scan, {overlap.scan}, 0, near);
    if (MayMove(step.align))
      AddAlignment(c.map, overlap.scan, scan, step.align, c.match.graph, ScanEdgeKind::kAlignment);
    result.steps.push_back(std::move(step));
  }
}

/// Moves all scans to where the edges agree best.
MatchPass OptimizeScans(const MatchContext& c, GraphRobust robust) {
  PoseGraph3& graph = c.map.graph.graph;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    graph.nodes[i].T_map_node = c.map.scans[i].T_map_laser;
  GraphOptions options;
  options.start = GraphStart::kGuess;
  options.robust = robust;
  const OptimizeResult<Pose3> optimized = Optimize(graph, options);
  MatchPass pass{.of = "graph", .scans = graph.nodes.size() - 1, .links = graph.edges.size()};
  pass.iterations = optimized.iterations.size();
  pass.settled = optimized.status == GraphStatus::kConverged;
  if (optimized.status == GraphStatus::kFailed) return pass;
  for (std::size_t i = 1; i < graph.nodes.size(); ++i) {
    MoveInPass(c.map.scans[i], optimized.graph.nodes[i].T_map_node, pass);
    graph.nodes[i].T_map_node = c.map.scans[i].T_map_laser;
  }
  return pass;
}

/// Without closures every edge is trusted.
GraphRobust RobustOf(const MatchContext& c) {
  const auto closures = std::ranges::count(c.map.graph.kinds, ScanEdgeKind::kClosure);
  return closures > 0 ? c.match.graph.robust : GraphRobust::kNone;
}

}  // namespace

bool CloseLoops(const MatchContext& c, MatchResult& result) {
  if (!c.match.graph.closure.enabled) return false;
  std::string closed_to;
  for (const ClosureCandidate& candidate : ProposeClosures(c.map, c.match, c.align, c.parallel)) {
    Closure closure = TryClosure(c.map, candidate, c.match, c.align, c.parallel);
    if (closure.accepted) {
      AddAlignment(c.map, closure.from, closure.to, closure.align, c.match.graph, ScanEdgeKind::kClosure);
      closed_to += fmt::format("{}{}", closed_to.empty() ? "" : ", ", closure.from);
    }
    result.closures.push_back(std::move(closure));
  }
  if (closed_to.empty()) return false;
  // A right closure of a long drift looks wrong until the poses have followed it, so first they do; then
  // the kernel drops it where what was known before speaks against it.
  result.passes.push_back(OptimizeScans(c, GraphRobust::kNone));
  if (c.match.graph.robust != GraphRobust::kNone)
    result.passes.push_back(OptimizeScans(c, c.match.graph.robust));
  result.registered = c.map.scans.back().registered = true;
  result.message += fmt::format("; closed to {}", closed_to);
  return true;
}

MatchResult MatchByGraph(const MatchContext& c) {
  AddMissingNodes(c.map, c.match.graph);
  MatchResult result = MatchToOverlapping(c);
  if (result.registered) AddEdges(c, result);
  CloseLoops(c, result);
  if (!result.registered) return result;
  result.passes.push_back(OptimizeScans(c, RobustOf(c)));
  const MatchPass& pass = result.passes.back();
  result.message = fmt::format("{}; {} edges, moved by {:.1f} cm", result.message, pass.links,
                               100.0 * pass.moved_translation);
  return result;
}

}  // namespace ariadne::slam
