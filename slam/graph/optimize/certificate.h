#pragma once

#include <string>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

enum class CertificateVerdict { kOptimal, kNotCertified };

/// What is proven about poses: that no other poses have an objective below lower_bound.
struct Certificate {
  CertificateVerdict verdict = CertificateVerdict::kNotCertified;
  std::string message;            // the verdict as a sentence, with numbers
  double objective = 0.0;         // SE-Sync's, at the poses
  double lower_bound = 0.0;       // of the objective over all poses
  double relative_gap = 0.0;      // (objective - lower_bound) / objective
  double least_eigenvalue = 0.0;  // bound from below of that of the certificate matrix
  double seconds = 0.0;           // not deterministic
};

/// Proves poses to be the global minimum of SE-Sync's objective (isotropic.h), or not: their certificate
/// matrix is positive semidefinite exactly if they are (Rosen et al., SE-Sync, 2019, Theorem 7, whose
/// converse holds for moderate noise only: "not certified" is no proof of the contrary). `graph` is
/// isotropic, has no priors and at most one fixed node.
/// A graph counts as optimal if the gap is below `max_relative_gap`. Where the poses are not settled well
/// enough for that, the bound is taken from a copy of them that is.
template <typename Pose>
Certificate Certify(const PoseGraph<Pose>& graph, double max_relative_gap = 1e-6);

}  // namespace ariadne::slam
