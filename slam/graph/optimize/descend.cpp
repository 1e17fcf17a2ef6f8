#include "slam/graph/optimize/descend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam/base/stopwatch.h"

namespace ariadne::slam {
namespace {

constexpr double kLeastDamping = 1e-12;
constexpr double kMostDamping = 1e10;  // a step that is damped more does not move anything
// From here on Newton's method is the faster one; before, the curvature of errors that are still large
// leads astray.
constexpr double kNearMinimum = 1e-2;  // share of the objective that a step promises to take away

/// Adds the time of its life to a sum.
class Timed {
 public:
  explicit Timed(double& sum) : sum_(sum) {}
  ~Timed() { sum_ += watch_.Seconds(); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& sum_;
  Stopwatch watch_;
};

template <typename Make>
auto TimedBy(double& sum, const Make& make) {
  const Timed timed(sum);
  return make();
}

constexpr double kLastDigits = 1e-12;  // of an objective, which is a sum over all edges

}  // namespace

template <typename Pose>
Descent<Pose>::Descent(const PoseGraph<Pose>& graph, GraphTimes& times)
    : times_(times), system_(TimedBy(times.symbolic, [&] { return NormalSystem<Pose>(graph); })) {}

template <typename Pose>
void Descent<Pose>::Linearize(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting) {
  const Timed timed(times_.linearize);
  system_.Linearize(graph, weighting, hessian_);
}

template <typename Pose>
bool Descent<Pose>::Factorize() {
  if (!factor_) {
    const Timed timed(times_.symbolic);
    factor_.emplace(system_.H());
  }
  const Timed timed(times_.factorize);
  ++last_.factorizations;
  if (damping_ == 0.0) return factor_->Factorize(system_.H());
  BlockMatrix damped = system_.H();
  damped.AddToDiagonal(damping_ * damped.DiagonalEntries().cwiseMax(1e-12));
  return factor_->Factorize(damped);
}

template <typename Pose>
auto Descent<Pose>::FindStep() -> std::optional<Step> {
  if (!Factorize()) return {};
  const Timed timed(times_.solve);
  Step step{factor_->Solve(-system_.g()), 0.0};
  if (!step.tau.allFinite()) return {};
  // f - f(tau) = -2 g.tau - tau.H tau, with H tau = -g.
  step.promised = -system_.g().dot(step.tau);
  return step;
}

template <typename Pose>
void Descent<Pose>::BeMoreCareful(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting) {
  if (hessian_ == Hessian::kGaussNewton) damping_ = std::max(10.0 * damping_, kLeastDamping);
  hessian_ = Hessian::kGaussNewton;
  Linearize(graph, weighting);
}

template <typename Pose>
PoseGraph<Pose> Descent<Pose>::Moved(const PoseGraph<Pose>& graph, const Eigen::VectorXd& tau) {
  const Timed timed(times_.linearize);
  PoseGraph<Pose> moved = graph;
  last_.step = 0.0;
  for (std::size_t v = 0; v < variables().node_of.size(); ++v) {
    Pose& T_map_node = moved.nodes[variables().node_of[v]].T_map_node;
    const typename Pose::Tangent step = tau.segment<Pose::kDof>(system_.H().row(v));
    T_map_node = Retract(T_map_node, step);
    last_.step = std::max(last_.step, step.norm());
  }
  return moved;
}

template <typename Pose>
bool Descent<Pose>::Improve(PoseGraph<Pose>& graph, const EdgeWeighting& weighting, double convergence,
                            bool& settled) {
  last_ = {system_.objective(), 0.0, 0.0, 0};
  for (; damping_ < kMostDamping; BeMoreCareful(graph, weighting)) {
    last_.damping = damping_;
    const std::optional<Step> step = FindStep();
    if (!step) continue;
    stepped_ = true;
    const double before = system_.objective();
    settled = damping_ == 0.0 && step->promised <= std::max(convergence * std::abs(before), least_promise_);
    PoseGraph<Pose> moved = Moved(graph, step->tau);
    if (settled) {
      // The model is exact here: the step is made unless the objective rises by more than rounding, for it
      // takes away what is left of the gradient, which a certificate sees long after the objective does.
      const Timed timed(times_.linearize);
      const double after = WeightedObjective(moved, weighting);
      if (after <= before + kLastDigits * std::abs(before)) graph = std::move(moved);
      objective_ = std::min(before, after);
      return true;
    }
    const Hessian used = hessian_;
    hessian_ = step->promised < kNearMinimum * before ? Hessian::kNewton : Hessian::kGaussNewton;
    Linearize(moved, weighting);
    if (system_.objective() < before) {
      objective_ = system_.objective();
      graph = std::move(moved);
      damping_ = damping_ <= kLeastDamping ? 0.0 : 0.1 * damping_;
      return true;
    }
    hessian_ = used;
  }
  return false;
}

template <typename Pose>
DescentOutcome Descent<Pose>::Run(PoseGraph<Pose>& graph, const EdgeWeighting& weighting,
                                  const GraphOptions& options,
                                  const std::function<void(const GraphIteration&)>& on_iteration) {
  DescentOutcome outcome;
  if (variables().node_of.empty()) {
    const double objective = WeightedObjective(graph, weighting);
    return {GraphStatus::kConverged, "every vertex is fixed", {}, objective, objective};
  }
  damping_ = 0.0;
  hessian_ = Hessian::kGaussNewton;
  Linearize(graph, weighting);
  outcome.objective_start = objective_ = system_.objective();
  // A kernel's own curvature is not in the matrix, so that its steps converge more slowly.
  const double convergence = (weighting.kernel == GraphRobust::kNone ? 1.0 : 1e-3) * options.convergence;
  least_promise_ = NegligibleObjective(graph);
  bool settled = false;
  while (!settled && outcome.iterations.size() < static_cast<std::size_t>(options.max_iterations)) {
    stepped_ = false;
    const bool improved = Improve(graph, weighting, convergence, settled);
    outcome.iterations.push_back(last_);
    if (on_iteration) on_iteration(last_);
    const double objective = outcome.objective = system_.objective();
    if (objective < 0.0 || !std::isfinite(objective) || !stepped_) {
      outcome.message = fmt::format(
          "the objective has come to {:.6g}, but has no minimum there: the information of some edge is "
          "not positive definite",
          objective);
      return outcome;
    }
    // Where not even a tiny step lowers it, it is a minimum to rounding.
    settled = settled || !improved;
  }
  outcome.objective = objective_;
  outcome.status = settled ? GraphStatus::kConverged : GraphStatus::kIterationLimit;
  outcome.message = fmt::format("{} after {} iterations", settled ? "converged" : "not converged",
                                outcome.iterations.size());
  return outcome;
}

template class Descent<Pose2>;
template class Descent<Pose3>;

}  // namespace ariadne::slam
