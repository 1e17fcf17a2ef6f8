#include "experiments/studies/graph_trials.h"

#include <array>

#include "experiments/metrics/nees.h"
#include "experiments/metrics/statistics.h"
#include "slam/base/stopwatch.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/optimize/certificate.h"
#include "slam/graph/optimize/covariance.h"
#include "slam/graph/optimize/normal_system.h"
#include "slam/sparse/block_cholesky.h"

namespace ariadne::experiments {
namespace {

using slam::GraphRobust;
using slam::GraphStart;
using slam::Pose3;
using Simulated = slam::SimulatedGraph<Pose3>;

constexpr std::array kKernels{GraphRobust::kNone,         GraphRobust::kHuber, GraphRobust::kCauchy,
                              GraphRobust::kGemanMcClure, GraphRobust::kDcs,   GraphRobust::kSwitchable,
                              GraphRobust::kGnc};
constexpr std::array kStarts{GraphStart::kChordal, GraphStart::kOdometry};

/// Wrong closures spoil a chordal start, which takes them all for right.
slam::GraphOptions FromOdometry(slam::GraphOptions options, GraphRobust kernel) {
  options.robust = kernel;
  options.start = GraphStart::kOdometry;
  return options;
}

slam::PoseGraph3 WithoutWrong(const Simulated& simulated) {
  slam::PoseGraph3 graph = simulated.graph;
  graph.edges.clear();
  for (std::size_t k = 0; k < simulated.graph.edges.size(); ++k) {
    if (!simulated.wrong_edge[k]) graph.edges.push_back(simulated.graph.edges[k]);
  }
  return graph;
}

}  // namespace

double PositionRms(const slam::PoseGraph3& graph, const std::vector<Pose3>& truth) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < truth.size(); ++i)
    distances.push_back(slam::TranslationDistance(graph.nodes[i].T_map_node, truth[i]));
  return Rms(distances);
}

ClosureVerdicts JudgeClosures(const Simulated& simulated, const std::vector<double>& edge_weights) {
  ClosureVerdicts verdicts;
  for (std::size_t k = 0; k < simulated.graph.edges.size(); ++k) {
    if (!slam::IsClosure(simulated.graph.edges[k])) continue;
    const bool kept = edge_weights.empty() || edge_weights[k] >= 0.5;
    if (simulated.wrong_edge[k]) {
      ++verdicts.wrong;
      verdicts.wrong_kept += kept ? 1 : 0;
    } else {
      ++verdicts.right;
      verdicts.right_rejected += kept ? 0 : 1;
    }
  }
  return verdicts;
}

std::vector<RobustTrial> TryKernels(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options,
                                    double wrong_share, std::uint64_t seed) {
  walk.wrong_closures = wrong_share;
  const Simulated spoiled = slam::SimulateGraph<Pose3>(walk, seed);
  const double reference =
      PositionRms(slam::Optimize(WithoutWrong(spoiled), FromOdometry(options, GraphRobust::kNone)).graph,
                  spoiled.truth);
  std::vector<RobustTrial> trials;
  for (const GraphRobust kernel : kKernels) {
    const auto result = slam::Optimize(spoiled.graph, FromOdometry(options, kernel));
    trials.push_back({wrong_share, seed, std::string(NameOf(kernel)),
                      PositionRms(result.graph, spoiled.truth), reference,
                      JudgeClosures(spoiled, result.edge_weights)});
  }
  return trials;
}

std::vector<StartTrial> TryStarts(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options,
                                  double noise, std::uint64_t seed) {
  walk.translation_noise *= noise;
  walk.rotation_noise *= noise;
  const Simulated simulated = slam::SimulateGraph<Pose3>(walk, seed);
  std::vector<StartTrial> trials;
  for (const GraphStart start : kStarts) {
    slam::GraphOptions from = options;
    from.start = start;
    const auto isotropic = slam::Optimize(slam::Isotropic(simulated.graph), from);
    StartTrial trial{noise, seed, std::string(NameOf(start)), isotropic.objective};
    trial.certified = slam::Certify(isotropic.graph).verdict == slam::CertificateVerdict::kOptimal;
    for (const slam::GraphIteration& iteration : isotropic.iterations)
      trial.factorizations += iteration.factorizations;
    trial.position_rms = PositionRms(isotropic.graph, simulated.truth);
    const auto full = slam::Optimize(simulated.graph, from);
    const auto covariances = slam::MarginalCovariances(full.graph);
    trial.nees = Nees(full.graph.nodes.back().T_map_node, simulated.truth.back(), covariances.nodes.back());
    trials.push_back(trial);
  }
  return trials;
}

SizeTrial TrySize(slam::SimulatedGraphOptions walk, const slam::GraphOptions& options, int poses,
                  std::uint64_t seed) {
  walk.poses = poses;
  const Simulated simulated = slam::SimulateGraph<Pose3>(walk, seed);
  const slam::PoseGraph3 graph = slam::Isotropic(simulated.graph);
  SizeTrial trial{poses, seed, graph.edges.size()};
  trial.factor_bytes = 8.0 * slam::BlockCholesky(slam::NormalSystem<Pose3>(graph).H()).entries();
  const auto result = slam::Optimize(graph, options);
  trial.optimize_seconds = result.times.total;
  trial.certify_seconds = slam::Certify(result.graph).seconds;
  const Stopwatch watch;
  slam::MarginalCovariances(result.graph);
  trial.covariance_seconds = watch.Seconds();
  return trial;
}

}  // namespace ariadne::experiments
