#pragma once

#include <ceres/cost_function.h>
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "slam/graph/factors/pose_block.h"

/// What the tests of factors share: a factor's values as matrices, its derivatives by central differences,
/// and poses of jets, which differentiate residuals that are written once more, independently.
namespace ariadne::slam {

/// Residuals and their derivative by the tangents of both poses side by side.
struct Linearized {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;

  double Cost() const { return residuals.squaredNorm(); }
  Eigen::VectorXd Gradient() const { return jacobian.transpose() * residuals; }
  Eigen::MatrixXd Hessian() const { return jacobian.transpose() * jacobian; }
};

template <typename Pose>
Eigen::VectorXd Residuals(const ceres::CostFunction& factor, const std::vector<Pose>& poses) {
  std::vector<PoseBlock<Pose>> blocks;
  for (const Pose& pose : poses) blocks.push_back(ToBlock(pose));
  std::vector<const double*> parameters;
  for (const auto& block : blocks) parameters.push_back(block.data());
  Eigen::VectorXd residuals(factor.num_residuals());
  EXPECT_TRUE(factor.Evaluate(parameters.data(), residuals.data(), nullptr));
  return residuals;
}

template <typename Pose>
Linearized Linearize(const ceres::CostFunction& factor, const std::vector<Pose>& poses) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, kBlockSize<Pose>, Eigen::RowMajor>;
  std::vector<PoseBlock<Pose>> blocks;
  for (const Pose& pose : poses) blocks.push_back(ToBlock(pose));
  std::vector<Rows> matrices(poses.size(), Rows::Constant(factor.num_residuals(), kBlockSize<Pose>, 1e99));
  std::vector<const double*> parameters;
  std::vector<double*> jacobians;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    parameters.push_back(blocks[k].data());
    jacobians.push_back(matrices[k].data());
  }
  Linearized result{Eigen::VectorXd(factor.num_residuals()),
                    Eigen::MatrixXd(factor.num_residuals(), Pose::kDof * poses.size())};
  EXPECT_TRUE(factor.Evaluate(parameters.data(), result.residuals.data(), jacobians.data()));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    result.jacobian.middleCols(Pose::kDof * k, Pose::kDof) = matrices[k].leftCols(Pose::kDof);
    EXPECT_EQ(matrices[k].rightCols(kBlockSize<Pose> - Pose::kDof).norm(), 0.0);
  }
  return result;
}

template <typename Pose>
Eigen::MatrixXd CentralDifferences(const ceres::CostFunction& factor, const std::vector<Pose>& poses) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd jacobian(factor.num_residuals(), Pose::kDof * poses.size());
  for (Eigen::Index c = 0; c < jacobian.cols(); ++c) {
    const auto at = [&](double step) {
      std::vector<Pose> moved = poses;
      Pose& pose = moved[static_cast<std::size_t>(c / Pose::kDof)];
      pose = pose * Pose::Exp(step * Pose::Tangent::Unit(c % Pose::kDof));
      return Residuals(factor, moved);
    };
    jacobian.col(c) = (at(kStep) - at(-kStep)) / (2.0 * kStep);
  }
  return jacobian;
}

/// In long double: what is checked against them has digits that double would lose on large coordinates.
using Jet12 = ceres::Jet<long double, 12>;
using JetVector = Eigen::Matrix<Jet12, 3, 1>;

template <typename Derived>
auto ToJets(const Eigen::MatrixBase<Derived>& matrix) {
  return matrix.template cast<long double>().template cast<Jet12>().eval();
}

/// T * Exp(tau) at tau = 0, where tau are the jets' variables from `first` on.
struct JetPose3 {
  Eigen::Quaternion<Jet12> rotation;
  JetVector translation;

  JetPose3(const Pose3& T, int first) : rotation(ToJets(T.rotation.coeffs())) {
    JetVector rho, theta;
    for (int k = 0; k < 3; ++k) {
      rho[k] = Jet12(0.0L, first + k);
      theta[k] = Jet12(0.0L, first + 3 + k);
    }
    const JetVector half = theta * Jet12(0.5L);  // exact to first order
    translation = ToJets(T.translation) + rotation * rho;
    rotation = rotation * Eigen::Quaternion<Jet12>(Jet12(1.0L), half.x(), half.y(), half.z());
  }
};

}  // namespace ariadne::slam
