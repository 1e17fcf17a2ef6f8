#include "slam/graph/factors/linearize_error.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "slam/geometry/so3.h"
#include "slam/graph/factors/between.h"
#include "slam/graph/factors/square_root.h"

namespace ariadne::slam {

// With X = T_from_to and D = Z^-1 X of the measurement Z, a tangent of T_map_to perturbs D on its right,
// and one of T_map_from makes D = Z^-1 Exp(-tau) X.
LinearizedError<Pose2> LinearizeError(const Pose2& T_from_to_measured, const Pose2& T_map_from,
                                      const Pose2& T_map_to, RotationError rotation_error) {
  const Pose2 X = Between(T_map_from, T_map_to);
  const Pose2 D = Between(T_from_to_measured, X);
  const bool chord = rotation_error == RotationError::kChord;
  const double slope = chord ? std::cos(0.5 * D.angle) : 1.0;
  const Eigen::Matrix2d R_Z_inverse = T_from_to_measured.RotationMatrix().transpose();
  LinearizedError<Pose2> result;
  result.error << D.translation, chord ? 2.0 * std::sin(0.5 * D.angle) : D.angle;
  result.by_to << D.RotationMatrix(), Eigen::Vector2d::Zero(), Eigen::RowVector3d(0.0, 0.0, slope);
  result.by_from << -R_Z_inverse, -R_Z_inverse * Eigen::Vector2d(-X.translation.y(), X.translation.x()),
      Eigen::RowVector3d(0.0, 0.0, -slope);
  return result;
}

LinearizedError<Pose3> LinearizeError(const Pose3& T_from_to_measured, const Pose3& T_map_from,
                                      const Pose3& T_map_to, RotationError) {
  const Pose3 X = Between(T_map_from, T_map_to);
  const Pose3 D = Between(T_from_to_measured, X);
  const double sign = D.rotation.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d half_error = sign * D.rotation.vec();
  // q (1, theta / 2) has the vector part v + (w I + [v]) theta / 2.
  const Eigen::Matrix3d slope =
      Hat(half_error) + sign * D.rotation.w() * Eigen::Matrix3d::Identity().eval();
  const Eigen::Matrix3d R_Z_inverse = T_from_to_measured.RotationMatrix().transpose();
  LinearizedError<Pose3> result;
  result.error << D.translation, 2.0 * half_error;
  result.by_to << D.RotationMatrix(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), slope;
  result.by_from << -R_Z_inverse, R_Z_inverse * Hat(X.translation), Eigen::Matrix3d::Zero(),
      -slope * X.RotationMatrix().transpose();
  return result;
}

template <typename Pose>
typename Pose::Square RootOfInformation(const typename Pose::Square& information) {
  const Eigen::LLT<typename Pose::Square, Eigen::Upper> factor(information);
  if (information.allFinite() && factor.info() == Eigen::Success) return factor.matrixU();
  typename Pose::Square root = Pose::Square::Zero();  // rank-deficient, or an error
  const Eigen::MatrixXd L = SquareRoot(information, "the information matrix of a measurement");
  root.topRows(L.cols()) = L.transpose();
  return root;
}

template Pose2::Square RootOfInformation<Pose2>(const Pose2::Square&);
template Pose3::Square RootOfInformation<Pose3>(const Pose3::Square&);

}  // namespace ariadne::slam
