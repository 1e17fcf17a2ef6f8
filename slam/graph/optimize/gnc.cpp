#include "slam/graph/optimize/gnc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

constexpr double kGrowth = 1.4;  // of mu per round, as the authors have it
constexpr int kMaxRounds = 200;

/// The weight of a closure with squared error s in the surrogate of parameter mu: 1 where it is certainly
/// in, 0 where it is certainly out.
double SurrogateWeight(double s, double mu, double c) {
  if (s <= mu / (mu + 1.0) * c) return 1.0;
  if (s >= (mu + 1.0) / mu * c) return 0.0;
  return std::sqrt(c * mu * (mu + 1.0) / s) - mu;
}

template <typename Pose>
double WorstClosure(const PoseGraph<Pose>& graph) {
  double worst = 0.0;
  for (const PoseEdge<Pose>& edge : graph.edges) {
    if (IsClosure(edge)) worst = std::max(worst, SquaredError(graph, edge));
  }
  return worst;
}

/// Sets the weights of the closures; whether all of them are (almost) 0 or 1.
template <typename Pose>
bool Weigh(const PoseGraph<Pose>& graph, double mu, double c, std::vector<double>& weights) {
  bool decided = true;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (!IsClosure(graph.edges[k])) continue;
    weights[k] = SurrogateWeight(SquaredError(graph, graph.edges[k]), mu, c);
    decided = decided && (weights[k] < 1e-3 || weights[k] > 1.0 - 1e-3);
  }
  return decided;
}

}  // namespace

template <typename Pose>
GncOutcome DescendGraduated(PoseGraph<Pose>& graph, Descent<Pose>& descent, double squared_scale,
                            const GraphOptions& options,
                            const std::function<void(const GraphIteration&)>& on_iteration) {
  GncOutcome outcome;
  EdgeWeighting weighting;
  weighting.weights.assign(graph.edges.size(), 1.0);
  // At this mu the surrogate is convex for the errors at hand. If none is above the scale, none is in
  // doubt.
  const double worst = WorstClosure(graph);
  double mu = squared_scale / std::max(2.0 * worst - squared_scale, 1e-12);
  bool decided = worst <= squared_scale;
  for (; !decided && outcome.rounds < kMaxRounds; ++outcome.rounds, mu *= kGrowth) {
    decided = Weigh(graph, mu, squared_scale, weighting.weights) && outcome.rounds > 0;
    GraphOptions coarse = options;
    coarse.convergence = std::max(options.convergence, 1e-4);  // the weights change anyway
    const DescentOutcome round = descent.Run(graph, weighting, coarse, on_iteration);
    outcome.descent.iterations.insert(outcome.descent.iterations.end(), round.iterations.begin(),
                                      round.iterations.end());
    if (round.status == GraphStatus::kFailed) {
      outcome.descent.message = round.message;
      return outcome;
    }
  }
  for (double& weight : weighting.weights) weight = weight > 0.5 ? 1.0 : 0.0;
  const DescentOutcome last = descent.Run(graph, weighting, options, on_iteration);
  outcome.descent.iterations.insert(outcome.descent.iterations.end(), last.iterations.begin(),
                                    last.iterations.end());
  outcome.descent.status = last.status;
  const auto out = std::count(weighting.weights.begin(), weighting.weights.end(), 0.0);
  outcome.descent.message = fmt::format("{}, {} rounds of graduated non-convexity, {} closures rejected",
                                        last.message, outcome.rounds, out);
  outcome.weights = std::move(weighting.weights);
  return outcome;
}

template GncOutcome DescendGraduated(PoseGraph2&, Descent<Pose2>&, double, const GraphOptions&,
                                     const std::function<void(const GraphIteration&)>&);
template GncOutcome DescendGraduated(PoseGraph3&, Descent<Pose3>&, double, const GraphOptions&,
                                     const std::function<void(const GraphIteration&)>&);

}  // namespace ariadne::slam
