#include "slam/graph/factors/optimize_with_ceres.h"

#include "slam/base/error.h"
#include "slam/graph/factors/graph_problem.h"
#include "slam/graph/factors/solve.h"

namespace ariadne::slam {
namespace {

ceres::SparseLinearAlgebraLibraryType InCeres(CeresLibrary library) {
  switch (library) {
    case CeresLibrary::kSuiteSparse:
      return ceres::SUITE_SPARSE;
    case CeresLibrary::kEigen:
      return ceres::EIGEN_SPARSE;
    case CeresLibrary::kCxSparse:
      return ceres::CX_SPARSE;
  }
  return ceres::SUITE_SPARSE;
}

ceres::Solver::Options InCeres(const GraphOptions& options, const CeresTuning& tuning) {
  ceres::Solver::Options solver = SolverOptions();
  solver.sparse_linear_algebra_library_type = InCeres(tuning.library);
  solver.initial_trust_region_radius = tuning.initial_trust_region_radius;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.convergence;
  // The share of the objective alone decides: these two depend on the units.
  solver.gradient_tolerance = 0.0;
  solver.parameter_tolerance = 0.0;
  return solver;
}

CeresStatus StatusOf(ceres::TerminationType type) {
  if (type == ceres::CONVERGENCE) return CeresStatus::kConverged;
  return type == ceres::NO_CONVERGENCE ? CeresStatus::kIterationLimit : CeresStatus::kFailed;
}

template <typename Pose>
CeresResult<Pose> ResultOf(const ceres::Solver::Summary& summary, std::vector<Pose> poses) {
  CeresResult<Pose> result{StatusOf(summary.termination_type), summary.message, std::move(poses), {}, {}};
  for (const ceres::IterationSummary& iteration : summary.iterations)
    result.objectives.push_back(2.0 * iteration.cost);
  result.factorizations = summary.num_linear_solves;
  result.linear_solver_seconds = summary.linear_solver_time_in_seconds;
  result.total_seconds = summary.total_time_in_seconds;
  return result;
}

/// What the kernel leaves of the information of each edge.
template <typename Pose>
std::vector<double> KernelWeights(const PoseGraph<Pose>& graph, const GraphOptions& options) {
  const double squared_scale = SquaredScale(options.robust_confidence, Pose::kDof);
  std::vector<double> weights;
  for (const PoseEdge<Pose>& edge : graph.edges) {
    const GraphRobust kernel = IsClosure(edge) ? options.robust : GraphRobust::kNone;
    weights.push_back(Evaluate(kernel, SquaredError(graph, edge), squared_scale).slope);
  }
  return weights;
}

}  // namespace

template <typename Pose>
CeresResult<Pose> OptimizeWithCeres(const PoseGraph<Pose>& graph, const GraphOptions& options,
                                    const CeresTuning& tuning) {
  if (!tuning.order.empty() && tuning.order.size() != graph.nodes.size())
    Fail("an order of {} nodes cannot be that of a graph of {}", tuning.order.size(), graph.nodes.size());
  GraphProblem<Pose> problem(graph, options);
  ceres::Solver::Options solver = InCeres(options, tuning);
  if (!tuning.order.empty()) solver.linear_solver_ordering = problem.Ordering(tuning.order);
  const ceres::Solver::Summary summary = SolveQuietly(solver, problem.problem());
  CeresResult<Pose> result = ResultOf(summary, problem.Poses());

  PoseGraph<Pose> at_result = graph;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) at_result.nodes[n].T_map_node = result.poses[n];
  result.objective = Objective(at_result);
  if (options.robust == GraphRobust::kSwitchable)
    result.edge_weights = problem.SquaredSwitches();
  else if (options.robust != GraphRobust::kNone)
    result.edge_weights = KernelWeights(at_result, options);
  return result;
}

template CeresResult<Pose2> OptimizeWithCeres(const PoseGraph2&, const GraphOptions&, const CeresTuning&);
template CeresResult<Pose3> OptimizeWithCeres(const PoseGraph3&, const GraphOptions&, const CeresTuning&);

}  // namespace ariadne::slam
