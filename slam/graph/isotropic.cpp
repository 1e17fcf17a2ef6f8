#include "slam/graph/isotropic.h"

#include <Eigen/Cholesky>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

/// tr(block^-1).
template <int kSize>
double TraceOfInverse(const Eigen::Matrix<double, kSize, kSize>& block, const char* of) {
  const Eigen::LLT<Eigen::Matrix<double, kSize, kSize>> factor(block);
  if (factor.info() != Eigen::Success)
    Fail("the information of {} is not positive definite, so that it has no isotropic weight", of);
  return factor.solve(Eigen::Matrix<double, kSize, kSize>::Identity()).trace();
}

Pose2::Square IsotropicInformation(const Pose2::Square& information) {
  const auto [kappa, tau] = IsotropicWeightsOf(information);
  return Eigen::Vector3d(tau, tau, 2.0 * kappa).asDiagonal();
}

Pose3::Square IsotropicInformation(const Pose3::Square& information) {
  const auto [kappa, tau] = IsotropicWeightsOf(information);
  Pose3::Tangent diagonal;
  diagonal << Eigen::Vector3d::Constant(tau), Eigen::Vector3d::Constant(2.0 * kappa);
  return diagonal.asDiagonal();
}

}  // namespace

IsotropicWeights IsotropicWeightsOf(const Pose2::Square& information) {
  if (!(information(2, 2) > 0.0))
    Fail("the information of an angle is not positive: {}", information(2, 2));
  return {information(2, 2), 2.0 / TraceOfInverse<2>(information.topLeftCorner<2, 2>(), "a translation")};
}

IsotropicWeights IsotropicWeightsOf(const Pose3::Square& information) {
  // On vec(q), half the angle, the information is four times that of the angle.
  return {4.0 * 1.5 / TraceOfInverse<3>(information.bottomRightCorner<3, 3>(), "a rotation"),
          3.0 / TraceOfInverse<3>(information.topLeftCorner<3, 3>(), "a translation")};
}

template <typename Pose>
PoseGraph<Pose> Isotropic(PoseGraph<Pose> graph) {
  for (PoseEdge<Pose>& edge : graph.edges) edge.information = IsotropicInformation(edge.information);
  for (PosePrior<Pose>& prior : graph.priors) prior.information = IsotropicInformation(prior.information);
  graph.rotation_error = RotationError::kChord;
  return graph;
}

template PoseGraph2 Isotropic(PoseGraph2);
template PoseGraph3 Isotropic(PoseGraph3);

}  // namespace ariadne::slam
