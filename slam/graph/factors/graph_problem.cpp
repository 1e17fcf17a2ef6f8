#include "slam/graph/factors/graph_problem.h"

#include <algorithm>

#include "slam/graph/factors/relative_pose.h"
#include "slam/graph/factors/switchable.h"

namespace ariadne::slam {
namespace {

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // they search for blocks that overlap
  return options;
}

}  // namespace

template <typename Pose>
GraphProblem<Pose>::GraphProblem(const PoseGraph<Pose>& graph, const GraphOptions& options)
    : switches_(graph.edges.size(), 1.0),
      loss_(options.robust, SquaredScale(options.robust_confidence, Pose::kDof)),
      problem_(ProblemOptions()) {
  for (const PoseNode<Pose>& node : graph.nodes) blocks_.push_back(ToBlock(node.T_map_node));
  bool held = !graph.priors.empty();
  for (std::size_t n = 0; n < blocks_.size(); ++n) {
    problem_.AddParameterBlock(block(n), kBlockSize<Pose>, &manifold_);
    held = held || graph.nodes[n].fixed;
    if (graph.nodes[n].fixed) problem_.SetParameterBlockConstant(block(n));
  }
  if (!held && !blocks_.empty()) problem_.SetParameterBlockConstant(block(0));
  for (std::size_t k = 0; k < graph.edges.size(); ++k) AddEdge(graph, k, options);
  for (const PosePrior<Pose>& prior : graph.priors) {
    problem_.AddResidualBlock(MakePriorFactor(prior, graph.rotation_error).release(), nullptr,
                              block(prior.node));
  }
}

template <typename Pose>
void GraphProblem<Pose>::AddEdge(const PoseGraph<Pose>& graph, std::size_t k, const GraphOptions& options) {
  const PoseEdge<Pose>& edge = graph.edges[k];
  double* const from = block(edge.from);
  double* const to = block(edge.to);
  const GraphRobust robust = IsClosure(edge) ? options.robust : GraphRobust::kNone;
  if (robust == GraphRobust::kSwitchable) {
    problem_.AddResidualBlock(MakeSwitchableFactor(edge, graph.rotation_error).release(), nullptr, from, to,
                              &switches_[k]);
    problem_.AddResidualBlock(MakeSwitchPrior(options.switch_weight).release(), nullptr, &switches_[k]);
    problem_.SetParameterLowerBound(&switches_[k], 0, 0.0);
    problem_.SetParameterUpperBound(&switches_[k], 0, 1.0);
  } else {
    problem_.AddResidualBlock(MakeRelativePoseFactor(edge, graph.rotation_error).release(),
                              robust == GraphRobust::kNone ? nullptr : &loss_, from, to);
  }
}

template <typename Pose>
std::shared_ptr<ceres::ParameterBlockOrdering> GraphProblem<Pose>::Ordering(
    const std::vector<std::int32_t>& order) {
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (std::size_t n = 0; n < blocks_.size(); ++n) ordering->AddElementToGroup(block(n), 1 + order[n]);
  for (double& x : switches_)
    if (problem_.HasParameterBlock(&x)) ordering->AddElementToGroup(&x, 0);
  return ordering;
}

template <typename Pose>
std::vector<Pose> GraphProblem<Pose>::Poses() const {
  std::vector<Pose> poses;
  for (const PoseBlock<Pose>& block : blocks_) poses.push_back(FromBlock<Pose>(block.data()));
  return poses;
}

template <typename Pose>
std::vector<double> GraphProblem<Pose>::SquaredSwitches() const {
  std::vector<double> squares;
  for (const double x : switches_) squares.push_back(x * x);
  return squares;
}

template class GraphProblem<Pose2>;
template class GraphProblem<Pose3>;

}  // namespace ariadne::slam
