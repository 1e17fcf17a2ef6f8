#pragma once

#include "slam/graph/optimize/variables.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// Sets the poses of the nodes that are not fixed by two linear least-squares problems (Carlone et al.,
/// "Initialization techniques for 3D SLAM", ICRA 2015): first the rotations as free matrices, with
/// sum kappa |R_j - R_i R_ij|^2, each then moved to the nearest rotation; then the translations with
/// sum tau |t_j - t_i - R_i t_ij|^2. The weights are those of isotropic.h; an edge whose information is not
/// positive definite counts with that of its trace. The nodes' guesses are not looked at.
template <typename Pose>
void InitializeByChords(PoseGraph<Pose>& graph, const GraphVariables& variables);

}  // namespace ariadne::slam
