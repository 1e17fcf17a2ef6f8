#include "slam/matching/match_joint.h"

#include <fmt/format.h>

#include <algorithm>

#include "slam/matching/joint_solve.h"
#include "slam/matching/match_graph.h"

namespace ariadne::slam {
namespace {

/// The scans lie to each other as all point pairs say; the edges of alignments follow.
void RefreshEdges(ScanMap& map) {
  PoseGraph3& graph = map.graph.graph;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) graph.nodes[i].T_map_node = map.scans[i].T_map_laser;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    PoseEdge<Pose3>& edge = graph.edges[k];
    if (map.graph.kinds[k] == ScanEdgeKind::kOdometry) continue;
    edge.T_from_to = map.scans[edge.from].T_map_laser.Inverse() * map.scans[edge.to].T_map_laser;
  }
}

/// Moves all scans but the master, and says by how much.
MatchPass PassOverAll(const MatchContext& c) {
  std::vector<MapScan>& scans = c.map.scans;
  if (NeedsModelSurfaces(c.align)) {
    for (MapScan& scan : scans) RequireSurfaces(scan, c.align.normal_neighbors, c.parallel);
  }
  JointProblem problem{std::vector<bool>(scans.size(), true), c.match.joint.max_iterations,
                       c.match.joint.convergence};
  problem.free[0] = false;
  const JointSolution solution = SolveJointly(scans, problem, c.match, c.align, c.parallel);
  MatchPass pass{.of = "joint",
                 .scans = scans.size() - 1,
                 .links = solution.scan_pairs,
                 .pairs = solution.pairs,
                 .rms = solution.rms,
                 .iterations = solution.iterations};
  pass.settled = solution.settled;
  for (std::size_t i = 0; i < scans.size(); ++i) MoveInPass(scans[i], solution.T_map_laser[i], pass);
  RefreshEdges(c.map);
  return pass;
}

}  // namespace

MatchResult MatchJointly(const MatchContext& c) {
  AddMissingNodes(c.map, c.match.graph);
  MatchResult result = MatchToOverlapping(c);
  if (result.registered) {
    // The edge is to the scan that it overlaps most, where the others are where they are.
    const MatchStep& step = result.steps.front();
    AddAlignment(c.map, step.partners.front(), step.scan, step.align, c.match.graph,
                 ScanEdgeKind::kAlignment);
  }
  const bool closed = CloseLoops(c, result);
  const int every = c.match.joint.pass_every;
  const bool due = every > 0 && c.map.scans.size() % static_cast<std::size_t>(every) == 0;
  if (closed || (due && result.registered)) result.passes.push_back(PassOverAll(c));
  return result;
}

MatchResult FinishJointly(const MatchContext& c) {
  MatchResult result;
  result.registered = true;
  if (c.map.scans.size() < 2) return result;
  result.passes.push_back(PassOverAll(c));
  const MatchPass& pass = result.passes.back();
  result.message =
      fmt::format("all scans at once: {} after {} iterations, {} pairs of scans, moved by {:.1f} cm",
                  pass.settled ? "settled" : "not settled", pass.iterations, pass.links,
                  100.0 * pass.moved_translation);
  return result;
}

}  // namespace ariadne::slam
