#include "slam/graph/pose_graph.h"

#include <cmath>

namespace ariadne::slam {

Pose2::Tangent PoseError(const Pose2& T_measured, const Pose2& T_estimated, RotationError rotation_error) {
  const Pose2 difference = T_measured.Inverse() * T_estimated;
  const double angle =
      rotation_error == RotationError::kAngle ? difference.angle : 2.0 * std::sin(0.5 * difference.angle);
  return {difference.translation.x(), difference.translation.y(), angle};
}

Pose3::Tangent PoseError(const Pose3& T_measured, const Pose3& T_estimated, RotationError) {
  const Pose3 difference = T_measured.Inverse() * T_estimated;
  const double sign = difference.rotation.w() < 0.0 ? -2.0 : 2.0;
  Pose3::Tangent error;
  error << difference.translation, sign * difference.rotation.vec();
  return error;
}

template <typename Pose>
double SquaredError(const PoseGraph<Pose>& graph, const PoseEdge<Pose>& edge) {
  const Pose T_from_to = graph.nodes[edge.from].T_map_node.Inverse() * graph.nodes[edge.to].T_map_node;
  const typename Pose::Tangent e = PoseError(edge.T_from_to, T_from_to, graph.rotation_error);
  return e.dot(edge.information * e);
}

template <typename Pose>
double Objective(const PoseGraph<Pose>& graph) {
  double sum = 0.0;
  for (const PoseEdge<Pose>& edge : graph.edges) sum += SquaredError(graph, edge);
  for (const PosePrior<Pose>& prior : graph.priors) {
    const typename Pose::Tangent e =
        PoseError(prior.T_map_node, graph.nodes[prior.node].T_map_node, graph.rotation_error);
    sum += e.dot(prior.information * e);
  }
  return sum;
}

template double SquaredError(const PoseGraph2&, const PoseEdge<Pose2>&);
template double SquaredError(const PoseGraph3&, const PoseEdge<Pose3>&);
template double Objective(const PoseGraph2&);
template double Objective(const PoseGraph3&);

}  // namespace ariadne::slam
