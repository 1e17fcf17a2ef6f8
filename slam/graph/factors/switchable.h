#pragma once

#include <ceres/cost_function.h>

#include <memory>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// A relative pose that can be turned off (Sünderhauf and Protzel, IROS 2012): residuals x U e, where the
/// switch x is a third parameter, a block of one number in [0, 1].
template <typename Pose>
std::unique_ptr<ceres::CostFunction> MakeSwitchableFactor(const PoseEdge<Pose>& edge,
                                                          RotationError rotation_error);

/// What it costs to turn it off: the residual weight (1 - x).
std::unique_ptr<ceres::CostFunction> MakeSwitchPrior(double weight);

}  // namespace ariadne::slam
