#pragma once

#include "slam/graph/pose_graph.h"

namespace ariadne::bench {

/// A pose graph solved as tutorials of Ceres do it: automatic differentiation, position and rotation as
/// separate parameter blocks, the library's own manifolds, all options but the linear solver at their
/// defaults, from the nodes' guesses. Returns the objective that is reached.
double OptimizeWithStockCeres(const slam::PoseGraph2& graph);
double OptimizeWithStockCeres(const slam::PoseGraph3& graph);

}  // namespace ariadne::bench
