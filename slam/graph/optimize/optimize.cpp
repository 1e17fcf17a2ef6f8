#include "slam/graph/optimize/optimize.h"

#include <array>

#include "slam/base/stopwatch.h"
#include "slam/graph/factors/optimize_with_ceres.h"
#include "slam/graph/kernels.h"
#include "slam/graph/optimize/chordal.h"
#include "slam/graph/optimize/descend.h"
#include "slam/graph/optimize/gnc.h"
#include "slam/graph/structure.h"

namespace ariadne::slam {
namespace {

constexpr const char* kSection = "graph.";  // of the options, in messages

template <typename Pose>
void Start(PoseGraph<Pose>& graph, const GraphVariables& variables, const GraphOptions& options) {
  const bool trusting = options.robust == GraphRobust::kNone;
  const GraphStart start = options.start != GraphStart::kAuto ? options.start
                           : trusting                         ? GraphStart::kChordal
                                                              : GraphStart::kOdometry;
  if (start == GraphStart::kChordal) InitializeByChords(graph, variables);
  if (start == GraphStart::kOdometry) PlaceAlongEdges(graph);
}

template <typename Pose>
void Keep(OptimizeResult<Pose>& result, DescentOutcome outcome) {
  result.status = outcome.status;
  result.message = std::move(outcome.message);
  result.iterations = std::move(outcome.iterations);
}

/// What the kernel leaves of each edge, at the end.
template <typename Pose>
std::vector<double> FinalWeights(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting) {
  std::vector<double> weights;
  for (std::size_t k = 0; k < graph.edges.size(); ++k)
    weights.push_back(weighting(graph, k, SquaredError(graph, graph.edges[k])).slope);
  return weights;
}

bool NeedsCeres(const GraphOptions& options) {
  if (options.robust == GraphRobust::kSwitchable) return true;
  return options.solver == GraphSolver::kCeres && options.robust != GraphRobust::kGnc;
}

template <typename Pose>
void DescendWithCeres(PoseGraph<Pose>& graph, const GraphOptions& options, OptimizeResult<Pose>& result) {
  CeresResult<Pose> ceres = OptimizeWithCeres(graph, options);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) graph.nodes[i].T_map_node = ceres.poses[i];
  for (const double objective : ceres.objectives) result.iterations.push_back({objective, 0.0, 0.0, 1});
  result.status = ceres.status == CeresStatus::kConverged        ? GraphStatus::kConverged
                  : ceres.status == CeresStatus::kIterationLimit ? GraphStatus::kIterationLimit
                                                                 : GraphStatus::kFailed;
  result.message = "Ceres: " + ceres.message;
  result.edge_weights = std::move(ceres.edge_weights);
  result.times.factorize = ceres.linear_solver_seconds;
}

template <typename Pose>
void DescendRobustly(PoseGraph<Pose>& graph, Descent<Pose>& descent, const GraphOptions& options,
                     const std::function<void(const GraphIteration&)>& on_iteration,
                     OptimizeResult<Pose>& result) {
  const EdgeWeighting weighting{options.robust, SquaredScale(options.robust_confidence, Pose::kDof), {}};
  if (options.robust == GraphRobust::kGnc) {
    GncOutcome outcome = DescendGraduated(graph, descent, weighting.squared_scale, options, on_iteration);
    result.edge_weights = std::move(outcome.weights);
    Keep(result, std::move(outcome.descent));
    return;
  }
  Keep(result, descent.Run(graph, weighting, options, on_iteration));
  result.edge_weights = FinalWeights(graph, weighting);
}

/// A plain descent on the whole graph has met its objective at the start and the end: they need not be
/// computed once more.
template <typename Pose>
void DescendPlainly(PoseGraph<Pose>& graph, Descent<Pose>& descent, const GraphOptions& options,
                    const std::function<void(const GraphIteration&)>& on_iteration,
                    OptimizeResult<Pose>& result) {
  DescentOutcome outcome = descent.Run(graph, {}, options, on_iteration);
  result.objective_start = outcome.objective_start;
  result.objective = outcome.objective;
  Keep(result, std::move(outcome));
}

}  // namespace

std::string_view Name(GraphStatus status) {
  constexpr std::array<std::string_view, 3> kNames{"converged", "iteration limit", "failed"};
  return kNames[static_cast<std::size_t>(status)];
}

template <typename Pose>
OptimizeResult<Pose> Optimize(PoseGraph<Pose> graph, const GraphOptions& options,
                              const std::function<void(const GraphIteration&)>& on_iteration) {
  CheckOptions(options, kSection);
  const Stopwatch total;
  CheckGraph(graph);
  OptimizeResult<Pose> result;
  result.objective_guess = Objective(graph);
  Descent<Pose> descent(graph, result.times);
  const Stopwatch starting;
  Start(graph, descent.variables(), options);
  result.times.start = starting.Seconds();
  if (options.solver == GraphSolver::kGaussNewton && options.robust == GraphRobust::kNone) {
    DescendPlainly(graph, descent, options, on_iteration, result);
  } else {
    result.objective_start = Objective(graph);
    if (NeedsCeres(options)) {
      DescendWithCeres(graph, options, result);
    } else {
      DescendRobustly(graph, descent, options, on_iteration, result);
    }
    result.objective = Objective(graph);
  }
  result.graph = std::move(graph);
  result.times.total = total.Seconds();
  return result;
}

template OptimizeResult<Pose2> Optimize(PoseGraph2, const GraphOptions&,
                                        const std::function<void(const GraphIteration&)>&);
template OptimizeResult<Pose3> Optimize(PoseGraph3, const GraphOptions&,
                                        const std::function<void(const GraphIteration&)>&);

}  // namespace ariadne::slam
