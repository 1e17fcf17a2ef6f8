#pragma once

#include "slam/graph/optimize/variables.h"
#include "slam/graph/pose_graph.h"
#include "slam/sparse/block_matrix.h"

namespace ariadne::slam {

/// The certificate matrix of SE-Sync: with X = [t_1 R_1 t_2 R_2 ...] the objective is tr(X M X^T), and
/// S = M - Lambda, where Lambda holds the multipliers of R^T R = I. For all other poses Y the objective is
/// tr(Lambda) + tr(Y S Y^T), so that S >= 0 proves X to be optimal. One block (t, R) per node.
struct CertificateMatrix {
  BlockMatrix S;
  double trace_of_multipliers = 0.0;
  double scale = 0.0;  // the largest entry of M's diagonal, against which rounding is to be seen
};

/// `graph` is isotropic and has no priors. All nodes are in the matrix; the gauge is removed by a weight on
/// the first translation, which changes nothing else.
template <typename Pose>
CertificateMatrix MakeCertificateMatrix(const PoseGraph<Pose>& graph);

}  // namespace ariadne::slam
