#include "slam/matching/loop_closure.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "slam/graph/kernels.h"
#include "slam/graph/optimize/covariance.h"

namespace ariadne::slam {
namespace {

constexpr int kMaxIterations = 60;  // a closure that needs more than the gate's way down is none
constexpr double kSigmas = 3.0;     // as far as a relative position is looked for

double LargestSigma(const Pose3::Square& covariance) {
  const Eigen::Matrix3d position = covariance.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(position, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()(2)));
}

/// The covariances of the poses of scans relative to the last one.
std::vector<Pose3::Square> CovariancesTo(const ScanMap& map, const std::vector<std::size_t>& scans) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const std::size_t i : scans) pairs.emplace_back(i, map.scans.size() - 1);
  PoseGraph3 graph = map.graph.graph;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) graph.nodes[i].T_map_node = map.scans[i].T_map_laser;
  return MarginalCovariances(graph, pairs).pairs;
}

/// With the wider gate hardly fewer points find a pair than after an alignment with the narrow one: where
/// they are too few for a closure already, it need not be tried.
std::size_t LeastPairs(const MapScan& scan, const MatchOptions& match) {
  const double share = match.graph.closure.min_overlap * static_cast<double>(scan.points_laser.size());
  return std::max(static_cast<std::size_t>(match.overlap_pairs), static_cast<std::size_t>(share));
}

/// Accepted where nothing speaks against it: the verdict is the first that does.
std::string FindObjection(const Closure& closure, const MatchOptions& match) {
  const ClosureOptions& options = match.graph.closure;
  const AlignResult& align = closure.align;
  if (align.status != AlignStatus::kConverged && align.status != AlignStatus::kDegenerate)
    return align.message;
  if (align.pairs <= static_cast<std::size_t>(match.overlap_pairs))
    return fmt::format("{} pairs, more than {} are needed", align.pairs, match.overlap_pairs);
  if (align.overlap < options.min_overlap)
    return fmt::format("an overlap of {:.0f} %, {:.0f} % are needed", 100.0 * align.overlap,
                       100.0 * options.min_overlap);
  if (align.rms > options.max_rms)
    return fmt::format("an rms of {:.1f} cm, {:.1f} cm are allowed", 100.0 * align.rms,
                       100.0 * options.max_rms);
  const double bound = SquaredScale(options.confidence, Pose3::kDof);
  if (closure.squared_distance > bound)
    return fmt::format("a squared distance of {:.1f} from the graph, {:.1f} are allowed",
                       closure.squared_distance, bound);
  return "";
}

}  // namespace

std::vector<ClosureCandidate> ProposeClosures(const ScanMap& map, const MatchOptions& match,
                                              const AlignOptions& align, const Parallel& parallel) {
  const std::size_t last = map.scans.size() - 1;
  std::vector<std::size_t> unjoined;
  for (std::size_t i = 0; i < last; ++i) {
    if (map.scans[i].registered && !AreJoined(map.graph, i, last)) unjoined.push_back(i);
  }
  std::vector<ClosureCandidate> candidates;
  if (unjoined.empty()) return candidates;
  const std::vector<Pose3::Square> covariances = CovariancesTo(map, unjoined);
  for (std::size_t k = 0; k < unjoined.size(); ++k) {
    ClosureCandidate candidate{unjoined[k], covariances[k], kSigmas * LargestSigma(covariances[k]), 0};
    const double distance =
        TranslationDistance(map.scans[candidate.scan].T_map_laser, map.scans[last].T_map_laser);
    const double reach = match.graph.closure.reach;
    if (candidate.radius <= align.max_distance || distance - candidate.radius > reach) continue;
    candidate.pairs =
        CountOverlap(map.scans[candidate.scan], map.scans[last],
                     align.max_distance + std::min(candidate.radius, reach), parallel, align.one_sided);
    if (candidate.pairs > LeastPairs(map.scans[last], match)) candidates.push_back(candidate);
  }
  std::ranges::stable_sort(candidates, std::greater{}, &ClosureCandidate::pairs);
  const auto most = static_cast<std::size_t>(match.graph.closure.max_candidates);
  if (candidates.size() > most) candidates.resize(most);
  return candidates;
}

Closure TryClosure(ScanMap& map, const ClosureCandidate& candidate, const MatchOptions& match,
                   const AlignOptions& align, const Parallel& parallel) {
  const std::size_t last = map.scans.size() - 1;
  MapScan& from = map.scans[candidate.scan];
  MapScan& to = map.scans[last];
  AlignOptions wide = align;
  wide.assess = true;
  wide.guess_share = 0.0;  // a closure is to contradict the guess, where it must
  wide.max_iterations = std::min(align.max_iterations, kMaxIterations);
  wide.start_distance = std::max(align.start_distance, candidate.radius);
  if (candidate.radius > align.start_distance)
    wide.search_radius = std::max(align.search_radius, candidate.radius);
  RequireSurfaces(from, align.normal_neighbors, parallel);
  RequireSurfaces(to, align.normal_neighbors, parallel);
  const AlignData data{to.points_laser.positions,
                       NeedsDataSurfaces(align) ? to.surfaces_laser : std::vector<SurfacePoint>{}};
  Closure closure;
  closure.from = candidate.scan;
  closure.to = last;
  closure.align = Align(UnionInMap(map.scans, {candidate.scan}), data, to.T_map_laser, wide);
  closure.moved_translation = TranslationDistance(to.T_map_laser, closure.align.T_model_data);
  if (closure.align.assessment) {
    const Pose3::Tangent difference = (to.T_map_laser.Inverse() * closure.align.T_model_data).Log();
    const Pose3::Square covariance = candidate.covariance + closure.align.assessment->covariance;
    closure.squared_distance = difference.dot(covariance.ldlt().solve(difference));
  }
  const std::string objection = FindObjection(closure, match);
  closure.accepted = objection.empty();
  closure.verdict = closure.accepted ? fmt::format("closed over {:.2f} m", closure.moved_translation)
                                     : "refused: " + objection;
  return closure;
}

}  // namespace ariadne::slam
