#include "slam/graph/optimize/normal_system.h"

namespace ariadne::slam {

template <typename Pose>
NormalSystem<Pose>::NormalSystem(const PoseGraph<Pose>& graph)
    : variables_(FindVariables(graph)), H_(kDof, variables_.order, variables_.places), g_(H_.size()) {
  edges_.reserve(graph.edges.size());
  for (const PoseEdge<Pose>& edge : graph.edges) {
    Edge own{RotatedPose<Pose>(edge.T_from_to),
             variables_.of_node[edge.from],
             variables_.of_node[edge.to],
             {},
             {},
             {}};
    const bool from_free = own.from_variable != GraphVariables::kFixed;
    const bool to_free = own.to_variable != GraphVariables::kFixed;
    if (from_free) own.from = H_.Diagonal(own.from_variable);
    if (to_free) own.to = H_.Diagonal(own.to_variable);
    if (from_free && to_free) own.between = H_.Find(own.from_variable, own.to_variable);
    edges_.push_back(own);
  }
}

template <typename Pose>
void NormalSystem<Pose>::AddGradient(std::size_t variable, const typename Pose::Tangent& gradient) {
  g_.template segment<kDof>(H_.row(variable)) += gradient;
}

template <typename Pose>
void NormalSystem<Pose>::AddEdge(const PoseGraph<Pose>& graph, std::size_t k,
                                 const EdgeWeighting& weighting, Hessian hessian) {
  using Square = typename Pose::Square;
  const Edge& own = edges_[k];
  const PoseEdge<Pose>& edge = graph.edges[k];
  const LinearError<Pose> linear = ariadne::slam::Linearize(own.measured, T_map_node_[edge.from],
                                                            T_map_node_[edge.to], graph.rotation_error);
  const typename Pose::Tangent whitened = edge.information * linear.e;
  const KernelValue cost = weighting(graph, k, linear.e.dot(whitened));
  objective_ += cost.value;
  if (cost.slope == 0.0) return;
  const typename Pose::Tangent y = cost.slope * whitened;
  const Square W_to = cost.slope * (edge.information * linear.J_to);
  const Square W_from = cost.slope * (edge.information * linear.J_from);
  Curvature<Pose> H{linear.J_from.transpose() * W_from, linear.J_from.transpose() * W_to,
                    linear.J_to.transpose() * W_to};
  if (hessian == Hessian::kNewton) {
    const Curvature<Pose> curvature = CurvatureOf(y, linear, own.measured, graph.rotation_error);
    H.from_from += curvature.from_from;
    H.from_to += curvature.from_to;
    H.to_to += curvature.to_to;
  }
  const bool from_free = own.from_variable != GraphVariables::kFixed;
  const bool to_free = own.to_variable != GraphVariables::kFixed;
  if (from_free) {
    H_.template Add<kDof>(own.from, H.from_from);
    AddGradient(own.from_variable, linear.J_from.transpose() * y);
  }
  if (to_free) {
    H_.template Add<kDof>(own.to, H.to_to);
    AddGradient(own.to_variable, linear.J_to.transpose() * y);
  }
  if (from_free && to_free) H_.template Add<kDof>(own.between, H.from_to);
}

template <typename Pose>
void NormalSystem<Pose>::AddPrior(const PosePrior<Pose>& prior, const PoseGraph<Pose>& graph) {
  const LinearError<Pose> linear =
      ariadne::slam::Linearize(RotatedPose<Pose>(prior.T_map_node), RotatedPose<Pose>(),
                               T_map_node_[prior.node], graph.rotation_error);
  objective_ += linear.e.dot(prior.information * linear.e);
  const std::size_t variable = variables_.of_node[prior.node];
  if (variable == GraphVariables::kFixed) return;
  const typename Pose::Square W = prior.information * linear.J_to;
  H_.template Add<kDof>(H_.Diagonal(variable), linear.J_to.transpose() * W);
  AddGradient(variable, W.transpose() * linear.e);
}

template <typename Pose>
void NormalSystem<Pose>::Linearize(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting,
                                   Hessian hessian) {
  H_.SetZero();
  g_.setZero();
  objective_ = 0.0;
  T_map_node_.clear();
  for (const PoseNode<Pose>& node : graph.nodes) T_map_node_.emplace_back(node.T_map_node);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) AddEdge(graph, k, weighting, hessian);
  for (const PosePrior<Pose>& prior : graph.priors) AddPrior(prior, graph);
}

template <typename Pose>
double WeightedObjective(const PoseGraph<Pose>& graph, const EdgeWeighting& weighting) {
  double sum = 0.0;
  for (std::size_t k = 0; k < graph.edges.size(); ++k)
    sum += weighting(graph, k, SquaredError(graph, graph.edges[k])).value;
  for (const PosePrior<Pose>& prior : graph.priors) {
    const typename Pose::Tangent e =
        PoseError(prior.T_map_node, graph.nodes[prior.node].T_map_node, graph.rotation_error);
    sum += e.dot(prior.information * e);
  }
  return sum;
}

template class NormalSystem<Pose2>;
template class NormalSystem<Pose3>;
template double WeightedObjective(const PoseGraph2&, const EdgeWeighting&);
template double WeightedObjective(const PoseGraph3&, const EdgeWeighting&);

}  // namespace ariadne::slam
