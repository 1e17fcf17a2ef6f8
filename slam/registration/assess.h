#pragma once

#include <Eigen/Core>

#include "slam/registration/align.h"
#include "slam/registration/correspondences.h"
#include "slam/registration/pair_weight.h"

namespace ariadne::slam {

/// A converged alignment, as AssessPairs() looks at it. Refers to its clouds and pairs.
struct Converged {
  const AlignModel& model;
  const AlignData& data;
  const Correspondences& pairs;
  const Pose3& T_model_data;
  const PairWeight& weight;
  const Eigen::Vector3d& center_data;
  double length;  // root mean square distance of the data from the center [m]
};

/// How certain the pose is: which motions the surfaces hold at all, and the covariance of the others.
///
/// The covariance is that of an M-estimator by the jackknife over cells of space: the scatter of the steps
/// that the pose would take if one cell after the other were left out, (H - H_cell)^-1 gradient_cell. H is
/// the derivative of the gradient of the error by the pose, including that of the weights. The cells are
/// about two neighbourhoods wide: within one, errors go together, because pairs share model points, and
/// normals share neighbours. Leaving out accounts for what the pose has already given in to the cell's own
/// errors, which the plain sandwich H^-1 B H^-1 ignores and so comes out too certain on few cells.
///
/// With point-to-point, the differences along the surface come from where the two scans happen to have
/// sampled it. They are noise (in the gradients), but they do not get larger when the data slides along the
/// surface, as new pairs form; so only the differences along the normal make up H.
///
/// Large clouds are assessed on whole cells chosen at random (but always the same), with some 2000 pairs.
Assessment AssessPairs(const Converged& converged, const AlignOptions& options);

}  // namespace ariadne::slam
