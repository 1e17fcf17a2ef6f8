#pragma once

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// The error of a relative pose (pose_graph.h), and its derivatives by the tangents of both poses.
template <typename Pose>
struct LinearizedError {
  typename Pose::Tangent error;  // (m, rad)
  typename Pose::Square by_from;
  typename Pose::Square by_to;
};

LinearizedError<Pose2> LinearizeError(const Pose2& T_from_to_measured, const Pose2& T_map_from,
                                      const Pose2& T_map_to, RotationError rotation_error);
LinearizedError<Pose3> LinearizeError(const Pose3& T_from_to_measured, const Pose3& T_map_from,
                                      const Pose3& T_map_to,
                                      RotationError rotation_error = RotationError::kChord);

/// U of information = U^T U, so that |U e|^2 = e^T information e. Error where the information is not
/// positive semidefinite: the squared error is no sum of squares then.
template <typename Pose>
typename Pose::Square RootOfInformation(const typename Pose::Square& information);

}  // namespace ariadne::slam
