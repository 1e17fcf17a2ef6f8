#pragma once

#include <functional>
#include <optional>

#include "slam/graph/graph_options.h"
#include "slam/graph/optimize/normal_system.h"
#include "slam/graph/optimize/optimize.h"
#include "slam/sparse/block_cholesky.h"

namespace ariadne::slam {

/// How a descent has ended.
struct DescentOutcome {
  GraphStatus status = GraphStatus::kFailed;
  std::string message;
  std::vector<GraphIteration> iterations;
  double objective_start = 0.0;  // with the weighting
  double objective = 0.0;        // at the end
};

/// Newton's method on CHOLMOD; where the objective is not convex, or does not fall, Gauss-Newton, and
/// damped after Levenberg and Marquardt where that does not help either. Keeps the symbolic factorization,
/// so that a graph can be descended on again and again.
template <typename Pose>
class Descent {
 public:
  /// Adds the time of what it does to `times`, which must outlive it.
  Descent(const PoseGraph<Pose>& graph, GraphTimes& times);

  /// Moves the nodes of the graph (whose edges are those of the constructor's) to a minimum.
  DescentOutcome Run(PoseGraph<Pose>& graph, const EdgeWeighting& weighting, const GraphOptions& options,
                     const std::function<void(const GraphIteration&)>& on_iteration);

  const GraphVariables& variables() const { return system_.variables(); }

 private:
  struct Step {
    Eigen::VectorXd tau;
    double promised = 0.0;  // by how much the quadratic model says that the objective falls
  };
  /// Nothing where the damped matrix is not positive definite.
  std::optional<Step> FindStep();
  bool Factorize();
  void Linearize(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting);
  /// After a failure: first without the curvature, then with more and more damping.
  void BeMoreCareful(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting);
  /// One step that lowers the objective, however damped; false where there is none.
  bool Improve(PoseGraph<Pose>& graph, const EdgeWeighting& weighting, double convergence, bool& settled);
  PoseGraph<Pose> Moved(const PoseGraph<Pose>& graph, const Eigen::VectorXd& tau);

  GraphTimes& times_;
  NormalSystem<Pose> system_;
  std::optional<BlockCholesky> factor_;
  double objective_ = 0.0;  // at the best poses so far
  double damping_ = 0.0;
  double least_promise_ = 0.0;  // below it the objective has no digits
  Hessian hessian_ = Hessian::kGaussNewton;
  bool stepped_ = false;  // whether the last iteration has found any step, good or bad
  GraphIteration last_;
};

}  // namespace ariadne::slam
