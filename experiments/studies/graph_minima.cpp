#include "experiments/studies/graph_minima.h"

#include <fmt/format.h>

#include <algorithm>

#include "slam/base/error.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/structure.h"

namespace ariadne::experiments {
namespace {

using slam::G2oFile;
using slam::GraphIteration;
using slam::OptimizeResult;
using slam::PoseGraph;

template <typename Pose>
std::string InformationObstacle(const G2oFile& file, const PoseGraph<Pose>& graph) {
  const std::vector<std::size_t> indefinite = slam::IndefiniteEdges(graph);
  if (indefinite.empty()) return "";
  return fmt::format(
      "{}:{}: the information matrix is not positive definite, as in {} of the {} edges, so that the "
      "file's "
      "own objective is unbounded",
      file.name, file.edge_lines[indefinite.front()], indefinite.size(), graph.edges.size());
}

template <typename Pose>
std::string IsotropicObstacle(const G2oFile& file, const PoseGraph<Pose>& graph) {
  std::string place;
  try {
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      place = fmt::format("{}:{}", file.name, file.edge_lines[i]);
      slam::IsotropicWeightsOf(graph.edges[i].information);
    }
    for (const slam::PosePrior<Pose>& prior : graph.priors) {
      place = fmt::format("{}: prior of vertex {}", file.name, graph.nodes[prior.node].id);
      slam::IsotropicWeightsOf(prior.information);
    }
  } catch (const Error& error) {
    return fmt::format("{}: {}", place, error.what());
  }
  return "";
}

/// Edges as they count after a robust optimization: with their weights, and without those that do not
/// count.
template <typename Pose>
PoseGraph<Pose> Weighted(const OptimizeResult<Pose>& result) {
  PoseGraph<Pose> graph = result.graph;
  if (result.edge_weights.empty()) return graph;
  graph.edges.clear();
  for (std::size_t i = 0; i < result.edge_weights.size(); ++i) {
    if (result.edge_weights[i] <= 0.0) continue;
    graph.edges.push_back(result.graph.edges[i]);
    graph.edges.back().information *= result.edge_weights[i];
  }
  return graph;
}

/// Why no certificate exists for such a graph; empty where it does.
template <typename Pose>
std::string CertificateObstacle(const PoseGraph<Pose>& graph) {
  if (!graph.priors.empty()) return "no certificate: there is none for graphs with priors";
  if (std::ranges::count(graph.nodes, true, &slam::PoseNode<Pose>::fixed) > 1)
    return "no certificate: there is none for graphs with several fixed vertices";
  return "";
}

template <typename Pose>
OptimizeResult<Pose> OptimizeShown(const PoseGraph<Pose>& graph, const slam::GraphOptions& options,
                                   const char* label, ProgressDisplay& progress) {
  int count = 0;
  OptimizeResult<Pose> result = slam::Optimize(graph, options, [&](const GraphIteration& iteration) {
    progress.Show(fmt::format("{}: iteration {}, objective {:.6g}", label, ++count, iteration.objective));
  });
  progress.Keep(fmt::format("{}: {}", label, result.message));
  return result;
}

template <typename Pose>
void AddCertificate(GraphMinima<Pose>& minima, ProgressDisplay& progress) {
  const std::string obstacle =
      minima.isotropic ? CertificateObstacle(minima.isotropic->graph)
                       : "no certificate: there is none for the objective of the full information";
  if (!obstacle.empty()) {
    minima.notes.push_back(obstacle);
    return;
  }
  progress.Show("certifying");
  minima.certificate = slam::Certify(Weighted(*minima.isotropic));
  progress.Keep(minima.certificate->message);
  if (!minima.isotropic->edge_weights.empty())
    minima.notes.emplace_back(
        "the certificate is of the graph with the weights that the robust kernel ended with");
}

}  // namespace

template <typename Pose>
GraphObstacles FindObstacles(const G2oFile& file, const PoseGraph<Pose>& graph) {
  return {InformationObstacle(file, graph), IsotropicObstacle(file, graph)};
}

void RequireObjective(const G2oFile& file, GraphObjective objective) {
  const GraphObstacles obstacles =
      std::visit([&](const auto& graph) { return FindObstacles(file, graph); }, file.graph);
  if (objective != GraphObjective::kInformation) {
    const bool other = objective == GraphObjective::kBoth && obstacles.information.empty();
    if (!obstacles.isotropic.empty() && !other) Fail("{}; correct or remove it", obstacles.isotropic);
  } else if (!obstacles.information.empty()) {
    Fail("{}; {}", obstacles.information,
         obstacles.isotropic.empty() ? "choose the isotropic one" : "correct or remove them");
  }
}

template <typename Pose>
GraphMinima<Pose> FindMinima(const G2oFile& file, const PoseGraph<Pose>& graph,
                             const OptimizeOptions& options, ProgressDisplay& progress) {
  RequireObjective(file, options.objective);
  const GraphObstacles obstacles = FindObstacles(file, graph);
  GraphMinima<Pose> minima;
  const auto optimize = [&](GraphObjective other, const std::string& obstacle, const auto& make_graph,
                            const char* label) -> std::optional<OptimizeResult<Pose>> {
    if (options.objective == other) return std::nullopt;
    if (obstacle.empty()) return OptimizeShown<Pose>(make_graph(), options.graph, label, progress);
    minima.notes.push_back(obstacle + fmt::format("; {} is left out", label));
    return std::nullopt;
  };
  minima.isotropic = optimize(
      GraphObjective::kInformation, obstacles.isotropic, [&] { return slam::Isotropic(graph); },
      "isotropic objective");
  minima.information = optimize(
      GraphObjective::kIsotropic, obstacles.information, [&] { return graph; }, "information objective");
  if (options.certify) AddCertificate(minima, progress);
  return minima;
}

template GraphObstacles FindObstacles(const G2oFile&, const slam::PoseGraph2&);
template GraphObstacles FindObstacles(const G2oFile&, const slam::PoseGraph3&);
template GraphMinima<slam::Pose2> FindMinima(const G2oFile&, const slam::PoseGraph2&,
                                             const OptimizeOptions&, ProgressDisplay&);
template GraphMinima<slam::Pose3> FindMinima(const G2oFile&, const slam::PoseGraph3&,
                                             const OptimizeOptions&, ProgressDisplay&);

}  // namespace ariadne::experiments
