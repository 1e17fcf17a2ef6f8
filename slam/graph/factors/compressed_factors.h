#pragma once

#include <ceres/cost_function.h>

#include <memory>

#include "slam/graph/factors/moments.h"

/// Factors that carry all point pairs of two scans at a cost that does not depend on their number. Cost,
/// gradient and Gauss-Newton Hessian are those of the sum over the pairs. Parameters are the blocks
/// (pose_block.h) of T_map_i and T_map_j, in this order. Ceres counts half of the energy as its cost.
/// Error where there are no pairs, a number is not finite, or negative weights prevail.
namespace ariadne::slam {

/// Energy sum w |T_map_i p_i - T_map_j p_j|^2, residuals in the map's frame: three per rank
/// of the moments, so 21 at most.
std::unique_ptr<ceres::CostFunction> MakePointFactor(const PointPairMoments& moments);

/// Energy sum e^T W e with e = T_j_i p_i - p_j, residuals in the frame of scan j: 13.
std::unique_ptr<ceres::CostFunction> MakePlaneFactor(const PlanePairMoments& moments);

}  // namespace ariadne::slam
