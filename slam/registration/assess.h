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
/// The covariance is that of an M-estimator, H^-1 B H^-1 (the sandwich). H is the derivative of the
/// gradient of the error by the pose, including that of the weights. B is the scatter of the gradient,
/// taken from the data itself and summed up by cells of space of about two neighbourhoods: within a cell,
/// errors go together, because pairs share model points, and normals share neighbours.
///
/// With point-to-point, the differences along the surface come from where the two scans happen to have
/// sampled it. They are noise (in B), but they do not get larger when the data slides along the surface, as
/// new pairs form; so only the differences along the normal make up H.
///
/// Large clouds are assessed on whole cells chosen at random (but always the same), with some 2000 pairs.
Assessment AssessPairs(const Converged& converged, const AlignOptions& options);

}  // namespace ariadne::slam
