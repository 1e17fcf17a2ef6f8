#pragma once

#include <cstdint>
#include <vector>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// A pose to be found.
template <typename Pose>
struct PoseNode {
  std::int64_t id = 0;  // its name in files
  Pose T_map_node;      // the best guess so far
  bool fixed = false;   // stays where it is
};

/// A measurement of one pose relative to another. It should be T_from_to * Exp(noise), with the noise's
/// information matrix in the tangent space of the pose: (m, rad).
template <typename Pose>
struct PoseEdge {
  std::size_t from = 0;  // indices of nodes
  std::size_t to = 0;
  Pose T_from_to;
  typename Pose::Square information = Pose::Square::Identity();
};

/// A measurement of one pose in the map.
template <typename Pose>
struct PosePrior {
  std::size_t node = 0;
  Pose T_map_node;
  typename Pose::Square information = Pose::Square::Identity();
};

/// How a rotation by theta off its measurement counts: by theta itself, or by the chord 2 sin(theta / 2).
/// In space it is always the chord along the axis, 2 vec(q): then the sum of squares is the chi2 of g2o
/// (whose matrices are on vec(q)). In the plane g2o takes the angle, and SE-Sync the chord.
enum class RotationError { kAngle, kChord };

/// Poses and measurements as plain data. The objective is the sum of e^T information e over all edges and
/// priors, where e = (translation, rotation error) of T_measured^-1 * T_from_to.
template <typename Pose>
struct PoseGraph {
  std::vector<PoseNode<Pose>> nodes;
  std::vector<PoseEdge<Pose>> edges;
  std::vector<PosePrior<Pose>> priors;
  RotationError rotation_error = RotationError::kAngle;  // Pose2 only
};

using PoseGraph2 = PoseGraph<Pose2>;
using PoseGraph3 = PoseGraph<Pose3>;

/// Whether an edge joins nodes that do not follow each other, so that it is no odometry and may be wrong.
template <typename Pose>
bool IsClosure(const PoseEdge<Pose>& edge) {
  return edge.from + 1 != edge.to && edge.to + 1 != edge.from;
}

/// e of the objective: (m, rad).
Pose2::Tangent PoseError(const Pose2& T_measured, const Pose2& T_estimated, RotationError rotation_error);
Pose3::Tangent PoseError(const Pose3& T_measured, const Pose3& T_estimated,
                         RotationError rotation_error = RotationError::kChord);

/// Squared error of one edge at the nodes' poses, e^T information e.
template <typename Pose>
double SquaredError(const PoseGraph<Pose>& graph, const PoseEdge<Pose>& edge);

/// The objective at the nodes' poses: chi2 as g2o counts it (without the factor 1/2).
template <typename Pose>
double Objective(const PoseGraph<Pose>& graph);

/// An objective that is nothing but rounding: that of measurements without errors, at their minimum.
template <typename Pose>
double NegligibleObjective(const PoseGraph<Pose>& graph) {
  constexpr double kOfOneResidual = 1e-14;
  return kOfOneResidual * Pose::kDof * static_cast<double>(graph.edges.size() + graph.priors.size());
}

}  // namespace ariadne::slam
