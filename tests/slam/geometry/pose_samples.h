#pragma once

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "slam/base/random.h"
#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

/// What the tests of Pose2 and Pose3 share: samples that sit on the difficult places, and the same motions
/// as homogeneous matrices in long double, made without the code under test.
namespace ariadne::slam {

template <typename Pose>
constexpr int kDimension = Pose::Point::RowsAtCompileTime;

template <typename Pose>
using Homogeneous = Eigen::Matrix<long double, kDimension<Pose> + 1, kDimension<Pose> + 1>;

template <typename Pose>
Homogeneous<Pose> ToMatrix(const Pose& pose) {
  Homogeneous<Pose> matrix = Homogeneous<Pose>::Identity();
  matrix.template topLeftCorner<kDimension<Pose>, kDimension<Pose>>() =
      pose.RotationMatrix().template cast<long double>();
  matrix.template topRightCorner<kDimension<Pose>, 1>() = pose.translation.template cast<long double>();
  return matrix;
}

template <typename Pose>
auto TranslationPart(const typename Pose::Tangent& tau) {
  return tau.template head<kDimension<Pose>>();
}

template <typename Pose>
auto RotationPart(const typename Pose::Tangent& tau) {
  return tau.template tail<Pose::kDof - kDimension<Pose>>();
}

/// The velocity matrix whose exponential is the motion: (translation, rotation) is the order of a tangent.
template <typename Pose>
Homogeneous<Pose> Wedge(const typename Pose::Tangent& tau) {
  Homogeneous<Pose> wedge = Homogeneous<Pose>::Zero();
  if constexpr (kDimension<Pose> == 2) {
    wedge << 0.0, -tau[2], tau[0], tau[2], 0.0, tau[1], 0.0, 0.0, 0.0;
  } else {
    wedge << 0.0, -tau[5], tau[4], tau[0], tau[5], 0.0, -tau[3], tau[1], -tau[4], tau[3], 0.0, tau[2], 0.0,
        0.0, 0.0, 0.0;
  }
  return wedge;
}

/// The exponential of a matrix by its Taylor sum, scaled and squared.
template <typename Matrix>
Matrix ExpByTaylor(const Matrix& a) {
  constexpr int kSquarings = 3;
  const Matrix scaled = a / (1 << kSquarings);
  Matrix sum = Matrix::Identity();
  Matrix term = Matrix::Identity();
  for (int k = 1; k <= 24; ++k) {
    term = (term * scaled / k).eval();
    sum += term;
  }
  for (int k = 0; k < kSquarings; ++k) sum = (sum * sum).eval();
  return sum;
}

/// Where ExpSo3, the left Jacobians and V of SE(2) leave their series, and where LogSo3 does: [rad]
inline const double kBranches[] = {1e-3, 2.0 * std::asin(1e-3)};

/// Angles of rotation from 0 up to just below pi, on both sides of each branch.
inline std::vector<double> SampleAngles() {
  std::vector<double> angles = {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2, 0.1, 0.7, 1.5, 2.9};
  for (const double branch : kBranches) {
    for (const double side : {0.9, 1.0 - 1e-9, std::nextafter(1.0, 0.0), 1.0, 1.0 + 1e-9, 1.1}) {
      angles.push_back(branch * side);
    }
  }
  for (const double rest : {1e-3, 1e-6, 1e-9}) angles.push_back(std::numbers::pi - rest);
  return angles;
}

template <int kRows>
Eigen::Matrix<double, kRows, 1> RandomDirection(RandomStream& stream) {
  Eigen::Matrix<double, kRows, 1> direction;
  for (double& x : direction) x = DrawNormal(stream, 0.0, 1.0);
  return direction.normalized();
}

template <typename Pose>
typename Pose::Tangent TangentWith(double length, double angle, RandomStream& stream) {
  typename Pose::Tangent tau;
  tau << length * RandomDirection<kDimension<Pose>>(stream),
      angle * RandomDirection<Pose::kDof - kDimension<Pose>>(stream);
  return tau;
}

/// Each of the angles with no, tiny and large translations in random directions.
template <typename Pose>
std::vector<typename Pose::Tangent> SampleTangents() {
  RandomStream stream = NamedStream(1, "pose_samples");
  std::vector<typename Pose::Tangent> samples;
  for (const double angle : SampleAngles()) {
    for (const double length : {0.0, 1e-9, 1.0, 30.0}) {
      samples.push_back(TangentWith<Pose>(length, angle, stream));
    }
  }
  return samples;
}

template <typename Pose>
std::vector<Pose> SamplePoses() {
  std::vector<Pose> poses;
  for (const auto& tau : SampleTangents<Pose>()) poses.push_back(Pose::Exp(tau));
  return poses;
}

/// The same motion: rotations to `tolerance`, translations to `tolerance` of 1 m or of their length.
MATCHER_P2(NearPose, expected, tolerance, "") {
  const auto matrix = ToMatrix(arg);
  const auto expected_matrix = ToMatrix(expected);
  const Eigen::Index n = matrix.rows() - 1;
  const auto difference = (matrix - expected_matrix).eval();
  const auto rotation_error = static_cast<double>(difference.topLeftCorner(n, n).norm());
  const auto translation_error = static_cast<double>(difference.topRightCorner(n, 1).norm());
  *result_listener << "\nexpected\n" << expected_matrix << "\nbut\n" << matrix;
  *result_listener << "\nrotation differs by " << rotation_error << ", translation by "
                   << translation_error;
  return rotation_error <= tolerance &&
         translation_error <= tolerance * (1.0 + expected.translation.norm());
}

}  // namespace ariadne::slam
