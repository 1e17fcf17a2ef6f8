#include "experiments/studies/graph_output.h"

#include <fmt/format.h>

#include "experiments/render/png_file.h"
#include "experiments/report/graph_picture.h"
#include "slam/io/file.h"
#include "slam/io/g2o.h"
#include "slam/io/trajectory.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;
using slam::Pose3;
using slam::PoseGraph;

constexpr const char* kGraphReadme =
    R"(What this run has left (units m, rad, s)

report.html     all of it at a glance, in any browser
config.yaml     all options, with their values; running it again gives the same bytes
manifest.json   what the run was made with: commit, compiler, libraries, BLAS, SHA-256 of the input
progress.json   how far the run has come: running, finished or failed
metrics.json    the results in numbers: both objectives, the certificate, notes
edges.csv       a line per edge: its line in the file, its squared error before and after, its weight
iterations.csv  a line per step of each descent
optimized.g2o   the file's graph with the best poses (of the information's objective, if it has a minimum)
trajectory.tum  the same poses, the number of the vertex as their time (evo reads this)
covariances.csv standard deviations of each pose in its own frame, if they were asked for
figures/        the graph before and after
timing.json     how long it took; the only file that differs from run to run
)";

Pose3 InSpace(const Pose2& pose) { return slam::ToPose3(pose); }
Pose3 InSpace(const Pose3& pose) { return pose; }

template <typename Pose>
std::vector<Eigen::Vector3d> Positions(const PoseGraph<Pose>& graph) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& node : graph.nodes) positions.push_back(InSpace(node.T_map_node).translation);
  return positions;
}

template <typename Pose>
DrawnGraph Drawn(const slam::OptimizeResult<Pose>& minimum) {
  DrawnGraph drawn;
  drawn.planar = std::is_same_v<Pose, Pose2>;
  for (std::size_t i = 0; i < minimum.graph.edges.size(); ++i) {
    const slam::PoseEdge<Pose>& edge = minimum.graph.edges[i];
    const double weight = minimum.edge_weights.empty() ? 1.0 : minimum.edge_weights[i];
    drawn.edges.push_back({edge.from, edge.to, IsClosure(edge), weight});
  }
  return drawn;
}

template <typename Pose>
void WriteTrajectory(const PoseGraph<Pose>& graph, const RunDirectory& run) {
  std::vector<slam::StampedPose> trajectory;
  for (const auto& node : graph.nodes) {
    trajectory.push_back({static_cast<double>(node.id), InSpace(node.T_map_node)});
  }
  slam::WriteFileAtomically(run.File("trajectory.tum"),
                            [&](std::ostream& out) { slam::WriteTum(out, trajectory); });
}

}  // namespace

template <typename Pose>
void WriteOptimizedGraph(const PoseGraph<Pose>& guess, const slam::OptimizeResult<Pose>& minimum,
                         const OptimizeOptions& options, const RunDirectory& run) {
  run.WriteText("README.txt", kGraphReadme);
  PoseGraph<Pose> optimized = guess;  // with the information of the file, whatever was made small
  for (std::size_t i = 0; i < optimized.nodes.size(); ++i) {
    optimized.nodes[i].T_map_node = minimum.graph.nodes[i].T_map_node;
  }
  slam::WriteFileAtomically(run.File("optimized.g2o"),
                            [&](std::ostream& out) { slam::WriteG2o(out, optimized); });
  WriteTrajectory(optimized, run);
  if (!options.figures) return;
  WritePng(run.File("figures/graph.png"),
           GraphPicture(Drawn(minimum), Positions(guess), Positions(optimized), "Before: the file's guess",
                        fmt::format("After: objective {:.6g}", minimum.objective)));
}

template void WriteOptimizedGraph(const slam::PoseGraph2&, const slam::OptimizeResult<Pose2>&,
                                  const OptimizeOptions&, const RunDirectory&);
template void WriteOptimizedGraph(const slam::PoseGraph3&, const slam::OptimizeResult<Pose3>&,
                                  const OptimizeOptions&, const RunDirectory&);

}  // namespace ariadne::experiments
