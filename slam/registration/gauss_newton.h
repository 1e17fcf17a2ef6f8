#pragma once

#include <Eigen/Core>
#include <vector>

#include "slam/base/parallel.h"
#include "slam/geometry/pose3.h"
#include "slam/registration/correspondences.h"
#include "slam/registration/options.h"
#include "slam/registration/pair_weight.h"
#include "slam/search/surface.h"

namespace ariadne::slam {

/// How the difference e = T d - m of a pair is measured, in the data frame: weight * (direction . e)^2,
/// one term for a plane, two for two planes, and an isotropic rest.
///
/// Generalized ICP weighs e with the inverse of the sum of both points' covariances. A point on a plane
/// with normal n has I - (1 - k) n n^T, k << 1. For unit normals a and b (signs chosen so that a.b >= 0)
/// the sum 2 I - (1 - k)(a a^T + b b^T) has the eigenvectors a + b and a - b, hence the inverse in closed
/// form. Here it is scaled by 2 k, so that a residual along a common normal counts as in point_to_plane.
struct PairError {
  Eigen::Vector3d e;          // [m]
  Eigen::Vector3d direction;  // of the first term
  Eigen::Vector3d second;     // of the second
  double first_weight = 1.0;
  double second_weight = 0.0;
  double isotropic_weight = 0.0;

  double Squared() const;  // [m^2]
  /// Squared() = e^T Information() e.
  Eigen::Matrix3d Information() const;
};

/// The clouds, and which of the plane metrics compares them. Refers to the clouds' vectors. The surfaces of
/// paired points have normals; point_to_plane looks at the model's alone.
struct PlaneMetric {
  const std::vector<Eigen::Vector3d>& model;
  const std::vector<SurfacePoint>& model_surfaces;
  const std::vector<Eigen::Vector3d>& data;
  const std::vector<SurfacePoint>& data_surfaces;
  Metric metric;

  PairError Error(std::size_t i, std::uint32_t model_index, const Pose3& T_model_data,
                  const Eigen::Matrix3d& R_data_model) const;
};

/// The normal equations H tau = -g of a Gauss-Newton step. tau perturbs the data about `center`:
/// T_model_data * Translate(center) * Exp(tau) * Translate(-center), which keeps H well-conditioned
/// wherever the origin of the data is.
struct NormalEquations {
  Pose3::Square H = Pose3::Square::Zero();
  Pose3::Tangent g = Pose3::Tangent::Zero();
  double sum_squared = 0.0;  // weighted squared residuals [m^2]
  double weight = 0.0;
  std::size_t pairs = 0;  // pairs with weight > 0

  NormalEquations& operator+=(const NormalEquations& other);
};

NormalEquations GatherNormalEquations(const PlaneMetric& metric, const Correspondences& pairs,
                                      const Pose3& T_model_data, const Eigen::Vector3d& center_data,
                                      const PairWeight& weight, const Parallel& parallel);

/// Adds a pair of points without surfaces, which counts with a weight: e = T d - m in the data frame. Only
/// to what the step is solved from, H and g.
void AddPointTerm(NormalEquations& equations, const Eigen::Vector3d& d_center, const Eigen::Vector3d& e,
                  double weight);

/// The squared residuals of all pairs [m^2].
std::vector<double> SquaredResiduals(const PlaneMetric& metric, const Correspondences& pairs,
                                     const Pose3& T_model_data);

/// The step -H^+ g. Directions in which H is singular to rounding get no step. `length` [m] makes rotations
/// comparable with translations: the root mean square distance of the data from the center.
Pose3::Tangent SolveStep(const NormalEquations& equations, double length);

/// Translate(center) * Exp(tau) * Translate(-center).
Pose3 ExpAbout(const Eigen::Vector3d& center, const Pose3::Tangent& tau);

}  // namespace ariadne::slam
