#pragma once

#include "slam/graph/linearize.h"
#include "slam/graph/optimize/variables.h"
#include "slam/graph/optimize/weighting.h"
#include "slam/sparse/block_matrix.h"

namespace ariadne::slam {

/// Which matrix stands for the second derivatives of the objective.
enum class Hessian {
  kGaussNewton,  // J^T information J: never negative
  kNewton        // with the curvature of the errors: exact, but far from a minimum perhaps not positive
};

/// The equations of a step, H tau = -g, with the objective f(tau) ~ f + 2 g.tau + tau.H tau.
template <typename Pose>
class NormalSystem {
 public:
  explicit NormalSystem(const PoseGraph<Pose>& graph);

  /// Linearizes all errors at the nodes' poses. The graph's edges are those of the constructor's.
  void Linearize(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting, Hessian hessian);

  const GraphVariables& variables() const { return variables_; }
  const BlockMatrix& H() const { return H_; }
  const Eigen::VectorXd& g() const { return g_; }
  double objective() const { return objective_; }

 private:
  static constexpr int kDof = Pose::kDof;
  /// An edge's measurement, and where its blocks lie. The places of a fixed node are not looked at.
  struct Edge {
    RotatedPose<Pose> measured;
    std::size_t from_variable, to_variable;
    BlockMatrix::Handle from, to, between;
  };

  void AddEdge(const PoseGraph<Pose>& graph, std::size_t k, const EdgeWeighting& weighting,
               Hessian hessian);
  void AddPrior(const PosePrior<Pose>& prior, const PoseGraph<Pose>& graph);
  void AddGradient(std::size_t variable, const typename Pose::Tangent& gradient);

  GraphVariables variables_;
  BlockMatrix H_;
  std::vector<Edge> edges_;
  std::vector<RotatedPose<Pose>> T_map_node_;
  Eigen::VectorXd g_;
  double objective_ = 0.0;
};

/// The objective with the weighting, at the nodes' poses.
template <typename Pose>
double WeightedObjective(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting);

}  // namespace ariadne::slam
