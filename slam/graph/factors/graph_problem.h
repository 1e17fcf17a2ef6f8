#pragma once

#include <ceres/ordered_groups.h>
#include <ceres/problem.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "slam/graph/factors/kernel_loss.h"
#include "slam/graph/factors/pose_block.h"
#include "slam/graph/graph_options.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// A pose graph as a problem of Ceres. It owns the numbers that the problem refers to, so it stays where it
/// was made.
template <typename Pose>
class GraphProblem {
 public:
  /// Kernels and switches apply to closures; a graph without fixed nodes and priors has its first node
  /// held.
  GraphProblem(const PoseGraph<Pose>& graph, const GraphOptions& options);
  GraphProblem(const GraphProblem&) = delete;
  GraphProblem& operator=(const GraphProblem&) = delete;

  ceres::Problem& problem() { return problem_; }
  double* block(std::size_t node) { return blocks_[node].data(); }

  /// For solvers: switches first, then the nodes, each at its place in the order of elimination.
  std::shared_ptr<ceres::ParameterBlockOrdering> Ordering(const std::vector<std::int32_t>& order);

  std::vector<Pose> Poses() const;

  /// Squares of the switches, which is what they leave of the edges' information; one per edge.
  std::vector<double> SquaredSwitches() const;

 private:
  void AddEdge(const PoseGraph<Pose>& graph, std::size_t k, const GraphOptions& options);

  std::vector<PoseBlock<Pose>> blocks_;
  std::vector<double> switches_;  // one per edge, in [0, 1]
  PoseManifold<Pose> manifold_;
  KernelLoss loss_;
  ceres::Problem problem_;
};

}  // namespace ariadne::slam
