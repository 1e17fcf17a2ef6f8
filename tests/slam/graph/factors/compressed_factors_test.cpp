// The compressed factors against the sums over all point pairs that they stand for.
#include "slam/graph/factors/compressed_factors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "slam/base/parallel.h"
#include "slam/base/random.h"
#include "slam/geometry/so3.h"
#include "slam/search/kd_tree.h"
#include "slam/search/surface.h"
#include "tests/slam/graph/factors/derivatives.h"
#include "tests/support/error_of.h"
#include "tests/support/hallway.h"

namespace ariadne::slam {
namespace {

struct PointPair {
  Eigen::Vector3d p_i;
  Eigen::Vector3d p_j;
  Eigen::Matrix3d information_j;  // its trace is the weight of point-to-point
};
using Pairs = std::vector<PointPair>;

/// Two scans' poses, and the pairs that are found there.
struct Case {
  std::string name;
  Pose3 T_map_i;
  Pose3 T_map_j;
  Pairs pairs;
};

PointMoments MomentsOfPoints(const Case& c, const Pose3& T_j_i_reference) {
  PointMoments moments(T_j_i_reference);
  for (const PointPair& pair : c.pairs) moments.Add(pair.p_i, pair.p_j, pair.information_j.trace());
  return moments;
}

PlaneMoments MomentsOfPlanes(const Case& c, const Pose3& T_j_i_reference) {
  PlaneMoments moments(T_j_i_reference);
  for (const PointPair& pair : c.pairs) moments.Add(pair.p_i, pair.p_j, pair.information_j);
  return moments;
}

/// Cost, gradient and Gauss-Newton Hessian, added pair by pair in long double.
struct Sums {
  long double cost = 0.0L;
  Eigen::Matrix<long double, 12, 1> gradient = Eigen::Matrix<long double, 12, 1>::Zero();
  Eigen::Matrix<long double, 12, 12> hessian = Eigen::Matrix<long double, 12, 12>::Zero();

  void Add(const JetVector& r, const Eigen::Matrix3d& information) {
    const Eigen::Vector3<long double> value(r.x().a, r.y().a, r.z().a);
    Eigen::Matrix<long double, 3, 12> J;
    for (int k = 0; k < 3; ++k) J.row(k) = r[k].v.transpose();
    const Eigen::Matrix3<long double> W = information.cast<long double>();
    cost += value.dot(W * value);
    gradient += J.transpose() * W * value;
    hessian += J.transpose() * W * J;
  }
};

JetVector Moved(const JetPose3& T, const Eigen::Vector3d& p) {
  return T.rotation * ToJets(p) + T.translation;
}

Sums SumOverPoints(const Case& c) {
  const JetPose3 T_map_i(c.T_map_i, 0), T_map_j(c.T_map_j, 6);
  Sums sums;
  for (const PointPair& pair : c.pairs) {
    const JetVector r = Moved(T_map_i, pair.p_i) - Moved(T_map_j, pair.p_j);
    sums.Add(r, pair.information_j.trace() * Eigen::Matrix3d::Identity());
  }
  return sums;
}

Sums SumOverPlanes(const Case& c) {
  const JetPose3 T_map_i(c.T_map_i, 0), T_map_j(c.T_map_j, 6);
  Sums sums;
  for (const PointPair& pair : c.pairs) {
    const JetVector from_j = Moved(T_map_i, pair.p_i) - T_map_j.translation;
    const JetVector e = T_map_j.rotation.conjugate() * from_j - ToJets(pair.p_j);
    sums.Add(e, pair.information_j);
  }
  return sums;
}

void ExpectSame(const ceres::CostFunction& factor, const Case& c, const Sums& expected, double far = 1.0) {
  const Linearized actual = Linearize<Pose3>(factor, {c.T_map_i, c.T_map_j});
  const auto cost = static_cast<double>(expected.cost);
  EXPECT_NEAR(actual.Cost(), cost, far * 1e-12 * cost) << c.name;
  const Eigen::MatrixXd hessian = expected.hessian.cast<double>();
  EXPECT_LE((actual.Hessian() - hessian).norm(), far * 1e-10 * hessian.norm()) << c.name;
  const Eigen::VectorXd gradient = expected.gradient.cast<double>();
  // Near a minimum the gradient is what remains of summands of this size.
  const double summands = std::sqrt(cost * hessian.norm());
  EXPECT_LE((actual.Gradient() - gradient).norm(), far * 1e-10 * gradient.norm() + 1e-13 * summands)
      << c.name;
}

Eigen::Vector3d DrawVector(RandomStream& stream, double sigma) {
  return {DrawNormal(stream, 0.0, sigma), DrawNormal(stream, 0.0, sigma), DrawNormal(stream, 0.0, sigma)};
}

Pose3 DrawPose(RandomStream& stream, double angle, double length) {
  Pose3::Tangent tau;
  tau << DrawVector(stream, length), angle * DrawVector(stream, 1.0).normalized();
  return Pose3::Exp(tau);
}

/// Pairs whose points differ by centimetres, with informations of rank 1 (planes) or 3.
Case RandomCase(RandomStream& stream, std::size_t count, double angle, double distance) {
  Case c{fmt::format("{} pairs, {} rad, {} m", count, angle, distance),
         DrawPose(stream, angle, distance),
         {},
         {}};
  c.T_map_j = c.T_map_i * DrawPose(stream, angle, 3.0);
  const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d p_i = DrawVector(stream, 5.0) + Eigen::Vector3d(12.0, -7.0, 2.0);
    const Eigen::Vector3d p_j = T_j_i * p_i + DrawVector(stream, 0.03);
    const Eigen::Vector3d n = DrawVector(stream, 1.0);
    Eigen::Matrix3d information = n * n.transpose();
    if (k % 3 == 0) information += DrawUniform(stream, 0.1, 1.0) * Eigen::Matrix3d::Identity();
    c.pairs.push_back({p_i, p_j, information});
  }
  return c;
}

std::vector<Case> RandomCases() {
  RandomStream stream = NamedStream(1, "compressed_factors_test");
  std::vector<Case> cases;
  for (const double angle : {0.0, 0.4, 3.14159}) {
    for (const double distance : {0.0, 10.0, 1000.0}) {
      for (const std::size_t count : {1, 2, 3, 5, 40, 1000})
        cases.push_back(RandomCase(stream, count, angle, distance));
    }
  }
  return cases;
}

TEST(CompressedFactors, AreTheSumOverAllPairs) {
  for (const Case& c : RandomCases()) {
    const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
    ExpectSame(*MakePointFactor(MomentsOfPoints(c, T_j_i)), c, SumOverPoints(c));
    ExpectSame(*MakePlaneFactor(MomentsOfPlanes(c, T_j_i)), c, SumOverPlanes(c));
  }
}

}  // namespace
}  // namespace ariadne::slam
