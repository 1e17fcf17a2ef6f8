// The compressed factors against the sums over all point pairs that they stand for.
#include "slam/graph/factors/compressed_factors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

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

PointPairMoments MomentsOfPoints(const Case& c, const Pose3& T_j_i_reference) {
  PointPairMoments moments(T_j_i_reference);
  for (const PointPair& pair : c.pairs) moments.Add(pair.p_i, pair.p_j, pair.information_j.trace());
  return moments;
}

PlanePairMoments MomentsOfPlanes(const Case& c, const Pose3& T_j_i_reference) {
  PlanePairMoments moments(T_j_i_reference);
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

void ExpectSame(const ceres::CostFunction& factor, const Case& c, const Sums& expected) {
  const Linearized actual = Linearize<Pose3>(factor, {c.T_map_i, c.T_map_j});
  const auto cost = static_cast<double>(expected.cost);
  EXPECT_NEAR(actual.Cost(), cost, 1e-12 * cost) << c.name;
  const Eigen::MatrixXd hessian = expected.hessian.cast<double>();
  EXPECT_LE((actual.Hessian() - hessian).norm(), 1e-10 * hessian.norm()) << c.name;
  const Eigen::VectorXd gradient = expected.gradient.cast<double>();
  // Near a minimum the gradient is what remains of summands of this size.
  const double summands = std::sqrt(cost * hessian.norm());
  EXPECT_LE((actual.Gradient() - gradient).norm(), 1e-10 * gradient.norm() + 1e-13 * summands) << c.name;
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
      for (const std::size_t count : {1, 2, 3, 5, 40, 300})
        cases.push_back(RandomCase(stream, count, angle, distance));
    }
  }
  return cases;
}

/// Both factors of a case are the sums that they stand for.
void ExpectSums(const Case& c, const Pose3& T_j_i_reference) {
  ExpectSame(*MakePointFactor(MomentsOfPoints(c, T_j_i_reference)), c, SumOverPoints(c));
  ExpectSame(*MakePlaneFactor(MomentsOfPlanes(c, T_j_i_reference)), c, SumOverPlanes(c));
}

TEST(CompressedFactors, AreTheSumOverAllPairs) {
  for (const Case& c : RandomCases()) ExpectSums(c, c.T_map_j.Inverse() * c.T_map_i);
}

TEST(CompressedFactors, AreTheSumOverAllPairsAwayFromTheirReference) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/away");
  for (Case& c : RandomCases()) {
    const Pose3 T_j_i_reference = c.T_map_j.Inverse() * c.T_map_i;
    c.T_map_i = c.T_map_i * DrawPose(stream, 0.02, 0.1);
    ExpectSums(c, T_j_i_reference);
    c.T_map_j = c.T_map_j * DrawPose(stream, 1.0, 2.0);
    ExpectSums(c, T_j_i_reference);
  }
}

/// Without a reference small residuals are differences of large sums: fewer digits, but the same minimum.
TEST(CompressedFactors, NeedNoReferenceForResidualsThatAreNotTiny) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/no_reference");
  for (Case& c : RandomCases()) {
    c.T_map_j = c.T_map_j * DrawPose(stream, 1.0, 2.0);
    ExpectSums(c, Pose3());
  }
}

TEST(CompressedFactors, AreTheSumWherePairsLeaveDirectionsFree) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/degenerate");
  const Case c = RandomCase(stream, 200, 0.4, 10.0);
  const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
  Case same = c, line = c, plane = c, one_normal = c;
  same.pairs.assign(50, c.pairs.front());
  const Eigen::Vector3d n = DrawVector(stream, 1.0).normalized();
  for (std::size_t k = 0; k < c.pairs.size(); ++k) {
    line.pairs[k].p_i = c.pairs[k].p_i.x() * n;
    plane.pairs[k].p_i -= n.dot(c.pairs[k].p_i) * n;
    one_normal.pairs[k].information_j = 7.0 * n * n.transpose();
    for (Case* moved : {&line, &plane})
      moved->pairs[k].p_j = T_j_i * moved->pairs[k].p_i + DrawVector(stream, 0.01);
  }
  for (const Case& degenerate : {same, line, plane, one_normal}) ExpectSums(degenerate, T_j_i);
  EXPECT_EQ(MakePointFactor(MomentsOfPoints(same, T_j_i))->num_residuals(), 3);
}

TEST(CompressedFactors, AreSmallHoweverManyPairsThereAre) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/size");
  const Case c = RandomCase(stream, 5000, 0.4, 10.0);
  EXPECT_EQ(MakePointFactor(MomentsOfPoints(c, {}))->num_residuals(), 21);
  EXPECT_EQ(MakePlaneFactor(MomentsOfPlanes(c, {}))->num_residuals(), 13);
}

TEST(CompressedFactors, HaveTheJacobiansOfTheirResiduals) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/jacobians");
  for (Case& c : RandomCases()) {
    const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
    c.T_map_i = c.T_map_i * DrawPose(stream, 0.3, 0.5);
    const std::vector<Pose3> poses = {c.T_map_i, c.T_map_j};
    for (const auto& factor :
         {MakePointFactor(MomentsOfPoints(c, T_j_i)), MakePlaneFactor(MomentsOfPlanes(c, T_j_i))}) {
      const Eigen::MatrixXd jacobian = Linearize(*factor, poses).jacobian;
      const double rounding = 1e-9 * (1.0 + 0.1 * c.T_map_i.translation.norm());  // of a difference's ends
      EXPECT_LE((jacobian - CentralDifferences(*factor, poses)).norm(), rounding * jacobian.norm())
          << c.name;
    }
  }
}

/// Partial sums over chunks, as threads make them, give the factor of the whole.
TEST(CompressedFactors, AddUpOverChunks) {
  RandomStream stream = NamedStream(1, "compressed_factors_test/chunks");
  const Case c = RandomCase(stream, 1000, 0.4, 10.0);
  const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
  const auto sum = [&](const auto& zero, int threads) {
    return Parallel(threads).Reduce(c.pairs.size(), 64, zero, [&](std::size_t begin, std::size_t end) {
      auto part = zero;
      for (std::size_t k = begin; k < end; ++k) {
        const PointPair& pair = c.pairs[k];
        if constexpr (std::is_same_v<decltype(part), PointPairMoments>)
          part.Add(pair.p_i, pair.p_j, pair.information_j.trace());
        else
          part.Add(pair.p_i, pair.p_j, pair.information_j);
      }
      return part;
    });
  };
  const PointPairMoments points = sum(PointPairMoments(T_j_i), 1);
  const PlanePairMoments planes = sum(PlanePairMoments(T_j_i), 1);
  EXPECT_EQ(points.pairs(), c.pairs.size());
  EXPECT_EQ(planes.pairs(), c.pairs.size());
  ExpectSame(*MakePointFactor(points), c, SumOverPoints(c));
  ExpectSame(*MakePlaneFactor(planes), c, SumOverPlanes(c));
  EXPECT_EQ(sum(PointPairMoments(T_j_i), 2).sum(), points.sum()) << "to the last bit";
  EXPECT_EQ(sum(PlanePairMoments(T_j_i), 2).sum(), planes.sum()) << "to the last bit";
}

TEST(CompressedFactors, SayWhatTheyCannotTake) {
  using testing::HasSubstr;
  EXPECT_THAT(ErrorOf([] { MakePointFactor(PointPairMoments()); }), HasSubstr("at least one pair"));
  EXPECT_THAT(ErrorOf([] { MakePlaneFactor(PlanePairMoments()); }), HasSubstr("at least one pair"));
  const Eigen::Vector3d p(1.0, 2.0, 3.0);
  PointPairMoments points;
  points.Add(p, p, -1.0);
  EXPECT_THAT(ErrorOf([&] { MakePointFactor(points); }), HasSubstr("not positive semidefinite"));
  PlanePairMoments planes;
  planes.Add(p, p, std::nan("") * Eigen::Matrix3d::Identity());
  EXPECT_THAT(ErrorOf([&] { MakePlaneFactor(planes); }), HasSubstr("not finite"));
  const Pose3 elsewhere = Pose3::Exp(Pose3::Tangent::Ones());
  EXPECT_THAT(ErrorOf([&] { points += PointPairMoments(elsewhere); }),
              HasSubstr("different reference poses"));
  EXPECT_THAT(ErrorOf([&] { planes += PlanePairMoments(elsewhere); }),
              HasSubstr("different reference poses"));
}

class CompressedHallwayPairs : public HallwayTest {
 protected:
  /// The points of one scan with their nearest ones in another, closer than half a metre, with normals.
  static Case PairUp(const PosedCloud& scan_i, const PosedCloud& scan_j) {
    Case c{"hallway", scan_i.T_map_laser, scan_j.T_map_laser, {}};
    const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
    const KdTree tree(scan_j.cloud_laser.positions);
    for (std::size_t k = 0; k < scan_i.cloud_laser.size(); k += 10) {
      const Eigen::Vector3d& p_i = scan_i.cloud_laser.positions[k];
      const Neighbor nearest = tree.Nearest(T_j_i * p_i, 0.5);
      if (nearest.index == kNoPoint) continue;
      const Eigen::Vector3d n = EstimateSurface(tree, nearest.index, 10).normal;
      if (!n.isZero(0.0)) c.pairs.push_back({p_i, tree.points()[nearest.index], n * n.transpose()});
    }
    return c;
  }
};

TEST_F(CompressedHallwayPairs, HaveFactorsThatAreTheirSums) {
  Case c = PairUp(Scans()[1], Scans()[0]);
  ASSERT_GT(c.pairs.size(), 2000u);
  const Pose3 T_j_i = c.T_map_j.Inverse() * c.T_map_i;
  ExpectSums(c, T_j_i);
  RandomStream stream = NamedStream(1, "compressed_factors_test/hallway");
  c.T_map_i = c.T_map_i * DrawPose(stream, 0.01, 0.05);
  ExpectSums(c, T_j_i);
}

}  // namespace
}  // namespace ariadne::slam
