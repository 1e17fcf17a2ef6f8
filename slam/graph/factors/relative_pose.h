#pragma once

#include <ceres/cost_function.h>

#include <memory>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// Factors whose residuals are U e, with U^T U the information and e as in pose_graph.h. Parameters are the
/// blocks (pose_block.h) of the poses from and to. Ceres counts half of the squared error as its cost.
template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakeRelativePoseFactor(const PoseEdge<Pose>& edge,
                                                            RotationError rotation_error);

/// The parameter is the block of the pose.
template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakePriorFactor(const PosePrior<Pose>& prior,
                                                     RotationError rotation_error);

}  // namespace ariadne::slam
