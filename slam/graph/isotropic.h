#pragma once

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// The weights that SE-Sync gives an edge: kappa |R_j - R_i R_ij|^2 + tau |t_j - t_i - R_i t_ij|^2.
struct IsotropicWeights {
  double kappa = 0.0;  // of the rotation (Frobenius norm)
  double tau = 0.0;    // of the translation [1/m^2]
};

/// In space kappa = 3 / (2 tr C_R), tau = 3 / tr C_t, where C_R and C_t are the inverses of the information
/// matrix's own rotation and translation blocks, with the rotation as g2o has it, on vec(q); in the plane
/// kappa = information of the angle, tau = 2 / tr C_t. Error where a block is not positive definite.
IsotropicWeights IsotropicWeightsOf(const Pose2::Square& information);
IsotropicWeights IsotropicWeightsOf(const Pose3::Square& information);

/// The same graph with SE-Sync's objective, whose global minimum can be proven (certificate.h). Priors are
/// made isotropic too.
template <typename Pose>
PoseGraph<Pose> Isotropic(PoseGraph<Pose> graph);

}  // namespace ariadne::slam
