#include "slam/matching/joint_solve.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "slam/base/blas_guard.h"
#include "slam/geometry/box3.h"
#include "slam/graph/factors/pose_block.h"
#include "slam/matching/joint_pair.h"

namespace ariadne::slam {
namespace {

/// Two scans, by their numbers, and their points.
struct Link {
  std::size_t model = 0;
  std::size_t data = 0;
  std::unique_ptr<JointPair> points;
  std::unique_ptr<ceres::CostFunction> factor;  // of this iteration
};

Box3 BoxInMap(const MapScan& scan) {
  Box3 box;
  for (const Eigen::Vector3d& p : scan.points_laser.positions) box.extend(scan.T_map_laser * p);
  return box;
}

/// All pairs of scans that may overlap, by the boxes around them.
std::vector<Link> FindCandidates(const std::vector<MapScan>& scans, const JointProblem& problem,
                                 double max_distance, bool both_ways) {
  std::vector<Box3> boxes;
  for (const MapScan& scan : scans) boxes.push_back(BoxInMap(scan));
  std::vector<Link> links;
  for (std::size_t data = 1; data < scans.size(); ++data) {
    for (std::size_t model = 0; model < data; ++model) {
      if (!scans[model].registered || !scans[data].registered) continue;
      if (!problem.free[model] && !problem.free[data]) continue;
      if (boxes[model].exteriorDistance(boxes[data]) > max_distance) continue;
      links.push_back({model, data, nullptr, nullptr});
      if (both_ways) links.push_back({data, model, nullptr, nullptr});
    }
  }
  return links;
}

/// Pairs the points of all links at the poses, and makes their factors.
void FindPairs(std::vector<Link>& links, const std::vector<Pose3>& T_map_laser, const AlignOptions& align,
               const Parallel& parallel) {
  parallel.For(links.size(), 1, [&](std::size_t k, std::size_t, std::size_t) {
    Link& link = links[k];
    const Pose3 T_model_data = T_map_laser[link.model].Inverse() * T_map_laser[link.data];
    const std::size_t pairs = link.points->FindPairs(T_model_data);
    const bool enough = pairs >= static_cast<std::size_t>(align.min_pairs);
    link.factor = enough ? link.points->MakeFactor() : nullptr;
  });
}

/// Whether two scans overlap by less than half of what is needed, as every eighth point tells. Most scans
/// of a large map do, and this is much cheaper than all their correspondences.
bool IsFarFromOverlap(const MapScan& model, const MapScan& data, std::size_t min_pairs,
                      double max_distance) {
  constexpr std::size_t kStride = 8;
  const Pose3 T_model_data = model.T_map_laser.Inverse() * data.T_map_laser;
  const std::vector<Eigen::Vector3d>& points = data.points_laser.positions;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < points.size(); i += kStride)
    pairs += model.tree_laser.Nearest(T_model_data * points[i], max_distance).index != kNoPoint;
  return 2 * kStride * pairs < min_pairs;
}

/// The links between scans that overlap.
std::vector<Link> FindLinks(const std::vector<MapScan>& scans, const JointProblem& problem,
                            const MatchOptions& match, const AlignOptions& align,
                            const Parallel& parallel) {
  std::vector<Link> links = FindCandidates(scans, problem, align.max_distance, match.joint.both_ways);
  parallel.For(links.size(), 1, [&](std::size_t k, std::size_t, std::size_t) {
    Link& link = links[k];
    const MapScan& model = scans[link.model];
    const MapScan& data = scans[link.data];
    const auto min_pairs = static_cast<std::size_t>(match.overlap_pairs);
    if (IsFarFromOverlap(model, data, min_pairs, align.max_distance)) return;
    link.points = std::make_unique<JointPair>(model, data, align);
    const Pose3 T_model_data = model.T_map_laser.Inverse() * data.T_map_laser;
    if (link.points->CountOverlap(T_model_data) <= min_pairs) link.points = nullptr;
  });
  std::erase_if(links, [](const Link& link) { return link.points == nullptr; });
  return links;
}

/// The poses that make the factors small.
std::vector<Pose3> SolveFactors(std::vector<Link>& links, const std::vector<Pose3>& T_map_laser,
                                const std::vector<bool>& moves) {
  std::vector<PoseBlock<Pose3>> blocks;
  for (const Pose3& pose : T_map_laser) blocks.push_back(ToBlock(pose));
  PoseManifold<Pose3> manifold;
  ceres::Problem::Options ownership;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  for (Link& link : links) {
    if (link.factor == nullptr) continue;
    problem.AddResidualBlock(link.factor.release(), nullptr, blocks[link.data].data(),
                             blocks[link.model].data());
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!problem.HasParameterBlock(blocks[i].data())) continue;
    problem.SetManifold(blocks[i].data(), &manifold);
    if (!moves[i]) problem.SetParameterBlockConstant(blocks[i].data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.initial_trust_region_radius = 1e16;  // damping would only slow down the long chains' bending
  options.max_num_iterations = 20;
  options.logging_type = ceres::SILENT;
  const BlasGuard guard;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return T_map_laser;
  std::vector<Pose3> solved = T_map_laser;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (moves[i]) solved[i] = FromBlock<Pose3>(blocks[i].data());
  }
  return solved;
}

/// Adds up what the iteration has seen.
void Describe(const std::vector<Link>& links, JointSolution& solution) {
  double sum_squared = 0.0, weight = 0.0;
  solution.pairs = 0;
  for (const Link& link : links) {
    if (link.factor == nullptr) continue;
    solution.pairs += link.points->size();
    sum_squared += link.points->sum_squared();
    weight += link.points->weight();
  }
  solution.rms = weight > 0.0 ? std::sqrt(sum_squared / weight) : 0.0;
}

bool Settled(const std::vector<Pose3>& before, const std::vector<Pose3>& after, double convergence) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (TranslationDistance(before[i], after[i]) > convergence ||
        RotationDistance(before[i], after[i]) > convergence) {
      return false;
    }
  }
  return true;
}

}  // namespace

JointSolution SolveJointly(const std::vector<MapScan>& scans, const JointProblem& problem,
                           const MatchOptions& match, const AlignOptions& align, const Parallel& parallel) {
  JointSolution solution;
  for (const MapScan& scan : scans) solution.T_map_laser.push_back(scan.T_map_laser);
  std::vector<Link> links = FindLinks(scans, problem, match, align, parallel);
  solution.scan_pairs = links.size();
  std::vector<bool> moves(scans.size(), false);
  for (const Link& link : links) {
    moves[link.model] = problem.free[link.model];
    moves[link.data] = problem.free[link.data];
  }
  while (!solution.settled && solution.iterations < static_cast<std::size_t>(problem.max_iterations)) {
    FindPairs(links, solution.T_map_laser, align, parallel);
    Describe(links, solution);
    std::vector<Pose3> solved = SolveFactors(links, solution.T_map_laser, moves);
    solution.settled = Settled(solution.T_map_laser, solved, problem.convergence);
    solution.T_map_laser = std::move(solved);
    ++solution.iterations;
  }
  return solution;
}

}  // namespace ariadne::slam
