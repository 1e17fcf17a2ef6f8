#include "slam/registration/gauss_newton.h"

#include <Eigen/Eigenvalues>

namespace ariadne::slam {
namespace {

constexpr double kPlaneThickness = 1e-3;  // k of the plane covariance, as in Segal's generalized ICP
constexpr double kSingular = 1e-12;       // eigenvalue, relative to the largest, that is rounding only

/// Adds one scalar residual r = direction . e with its derivative by tau.
void AddTerm(NormalEquations& sum, const Eigen::Vector3d& direction, const Eigen::Vector3d& d_center,
             const Eigen::Vector3d& e, double weight) {
  Pose3::Tangent jacobian;
  jacobian << direction, d_center.cross(direction);
  const Pose3::Tangent weighted = weight * jacobian;
  sum.H += weighted * jacobian.transpose();
  sum.g += direction.dot(e) * weighted;
}

}  // namespace

double PairError::Squared() const {
  const double first = direction.dot(e);
  const double other = second.dot(e);
  return first_weight * first * first + second_weight * other * other + isotropic_weight * e.squaredNorm();
}

Eigen::Matrix3d PairError::Information() const {
  return first_weight * direction * direction.transpose() + second_weight * second * second.transpose() +
         isotropic_weight * Eigen::Matrix3d::Identity();
}

PairError PlaneMetric::Error(std::size_t i, std::uint32_t model_index, const Pose3& T_model_data,
                             const Eigen::Matrix3d& R_data_model) const {
  PairError error;
  error.e = data[i] + R_data_model * (T_model_data.translation - model[model_index]);
  error.direction = R_data_model * model_surfaces[model_index].normal;
  error.second.setZero();
  if (metric == Metric::kPointToPlane) return error;

  const Eigen::Vector3d a = error.direction;
  const Eigen::Vector3d& n = data_surfaces[i].normal;
  const Eigen::Vector3d b = a.dot(n) < 0.0 ? Eigen::Vector3d(-n) : n;
  const double c = a.dot(b);
  constexpr double k = kPlaneThickness;
  error.direction = a + b;
  error.second = a - b;
  error.first_weight = 0.5 * k * (1.0 - k) / (2.0 - (1.0 - k) * (1.0 + c));
  error.second_weight = 0.5 * k * (1.0 - k) / (2.0 - (1.0 - k) * (1.0 - c));
  error.isotropic_weight = k;
  return error;
}

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
  H += other.H;
  g += other.g;
  sum_squared += other.sum_squared;
  weight += other.weight;
  pairs += other.pairs;
  return *this;
}

NormalEquations GatherNormalEquations(const PlaneMetric& metric, const Correspondences& pairs,
                                      const Pose3& T_model_data, const Eigen::Vector3d& center_data,
                                      const PairWeight& weight, const Parallel& parallel) {
  const Eigen::Matrix3d R_data_model = T_model_data.RotationMatrix().transpose();
  return parallel.Reduce(
      pairs.model_index.size(), kPairsPerChunk, NormalEquations{}, [&](std::size_t begin, std::size_t end) {
        NormalEquations sum;
        for (std::size_t i = begin; i < end; ++i) {
          if (pairs.model_index[i] == kNoPoint) continue;
          const PairError error = metric.Error(i, pairs.model_index[i], T_model_data, R_data_model);
          const double squared = error.Squared();
          const double w = weight(squared);
          if (w == 0.0) continue;
          const Eigen::Vector3d d_center = metric.data[i] - center_data;
          AddTerm(sum, error.direction, d_center, error.e, w * error.first_weight);
          if (error.isotropic_weight > 0.0) {
            AddTerm(sum, error.second, d_center, error.e, w * error.second_weight);
            for (int axis = 0; axis < 3; ++axis) {
              AddTerm(sum, Eigen::Vector3d::Unit(axis), d_center, error.e, w * error.isotropic_weight);
            }
          }
          sum.sum_squared += w * squared;
          sum.weight += w;
          ++sum.pairs;
        }
        return sum;
      });
}

void AddPointTerm(NormalEquations& equations, const Eigen::Vector3d& d_center, const Eigen::Vector3d& e,
                  double weight) {
  for (int axis = 0; axis < 3; ++axis) AddTerm(equations, Eigen::Vector3d::Unit(axis), d_center, e, weight);
}

std::vector<double> SquaredResiduals(const PlaneMetric& metric, const Correspondences& pairs,
                                     const Pose3& T_model_data) {
  const Eigen::Matrix3d R_data_model = T_model_data.RotationMatrix().transpose();
  std::vector<double> squared;
  squared.reserve(pairs.model_index.size());
  for (std::size_t i = 0; i < pairs.model_index.size(); ++i) {
    if (pairs.model_index[i] == kNoPoint) continue;
    squared.push_back(metric.Error(i, pairs.model_index[i], T_model_data, R_data_model).Squared());
  }
  return squared;
}

Pose3::Tangent SolveStep(const NormalEquations& equations, double length) {
  Pose3::Tangent scale;
  scale << 1.0, 1.0, 1.0, 1.0 / length, 1.0 / length, 1.0 / length;
  const Pose3::Square H = scale.asDiagonal() * equations.H * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Pose3::Square> solver(H);
  const Pose3::Tangent& eigenvalues = solver.eigenvalues();
  Pose3::Tangent step = solver.eigenvectors().transpose() * (scale.asDiagonal() * equations.g);
  for (int i = 0; i < Pose3::kDof; ++i) {
    step(i) = eigenvalues(i) > kSingular * eigenvalues(Pose3::kDof - 1) ? -step(i) / eigenvalues(i) : 0.0;
  }
  return scale.asDiagonal() * (solver.eigenvectors() * step);
}

Pose3 ExpAbout(const Eigen::Vector3d& center, const Pose3::Tangent& tau) {
  const Pose3 motion = Pose3::Exp(tau);
  return {motion.rotation, motion.translation + center - motion.rotation * center};
}

}  // namespace ariadne::slam
