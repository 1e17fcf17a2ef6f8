#pragma once

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// A pose with its rotation as a matrix, for work on many edges.
template <typename Pose>
struct RotatedPose {
  using Rotation = Eigen::Matrix<double, Pose::Point::RowsAtCompileTime, Pose::Point::RowsAtCompileTime>;
  Pose pose;
  Rotation R;

  RotatedPose() : R(Rotation::Identity()) {}
  explicit RotatedPose(const Pose& p) : pose(p), R(p.RotationMatrix()) {}
};

/// PoseError() of an edge, its derivatives by the tangents of both poses, and what its curvature needs.
template <typename Pose>
struct LinearError {
  typename Pose::Tangent e;
  typename Pose::Square J_from;
  typename Pose::Square J_to;
  Pose difference;               // T_measured^-1 T_from_to
  typename Pose::Point to_from;  // where `to` is, in the frame of `from` [m]
  typename RotatedPose<Pose>::Rotation R_from_to;
};

LinearError<Pose2> Linearize(const RotatedPose<Pose2>& measured, const RotatedPose<Pose2>& T_map_from,
                             const RotatedPose<Pose2>& T_map_to, RotationError rotation_error);
LinearError<Pose3> Linearize(const RotatedPose<Pose3>& measured, const RotatedPose<Pose3>& T_map_from,
                             const RotatedPose<Pose3>& T_map_to, RotationError rotation_error);

/// The second derivatives of y.e by the tangents (y is constant), where a tangent (rho, phi) moves a pose
/// to (R Exp(phi), t + R rho). With y = information e they complete Gauss-Newton's matrix to Newton's.
template <typename Pose>
struct Curvature {
  typename Pose::Square from_from;
  typename Pose::Square from_to;
  typename Pose::Square to_to;
};

Curvature<Pose2> CurvatureOf(const Pose2::Tangent& y, const LinearError<Pose2>& linear,
                             const RotatedPose<Pose2>& measured, RotationError rotation_error);
Curvature<Pose3> CurvatureOf(const Pose3::Tangent& y, const LinearError<Pose3>& linear,
                             const RotatedPose<Pose3>& measured, RotationError rotation_error);

/// The pose (R Exp(phi), t + R rho). To first order it is T * Exp(tau).
Pose2 Retract(const Pose2& pose, const Pose2::Tangent& tau);
Pose3 Retract(const Pose3& pose, const Pose3::Tangent& tau);

}  // namespace ariadne::slam
