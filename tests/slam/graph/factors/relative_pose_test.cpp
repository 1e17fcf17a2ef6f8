// Relative poses, priors and switches against residuals that are written once more, with jets.
#include "slam/graph/factors/relative_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "slam/base/random.h"
#include "slam/geometry/angles.h"
#include "slam/graph/factors/square_root.h"
#include "slam/graph/factors/switchable.h"
#include "slam/graph/linearize.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/slam/graph/factors/derivatives.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

using std::numbers::pi;

/// A measurement, with full information, and two poses at which it is off by a rotation of a given angle.
template <typename Pose>
struct Sample {
  PoseEdge<Pose> edge;
  Pose T_map_from;
  Pose T_map_to;
};

template <typename Pose>
typename Pose::Square DrawInformation(RandomStream& stream) {
  typename Pose::Square root;
  for (double& x : root.reshaped()) x = DrawNormal(stream, 0.0, 3.0);
  return root * root.transpose() + 0.1 * Pose::Square::Identity();
}

template <typename Pose>
std::vector<Sample<Pose>> Samples() {
  RandomStream stream = NamedStream(1, "relative_pose_test");
  std::vector<Sample<Pose>> samples;
  for (const double pose_angle : {0.0, 0.5, 2.0, pi - 1e-6}) {
    for (const double off : {0.0, 1e-9, 1e-4, 0.1, 1.0, 3.0, pi - 1e-4}) {
      for (const double length : {0.0, 0.5, 30.0}) {
        const auto draw = [&](double angle) { return Pose::Exp(TangentWith<Pose>(length, angle, stream)); };
        Sample<Pose> sample{{0, 1, draw(pose_angle), DrawInformation<Pose>(stream)}, draw(pose_angle), {}};
        sample.T_map_to = sample.T_map_from * sample.edge.T_from_to * draw(off);
        samples.push_back(sample);
      }
    }
  }
  return samples;
}

/// e of pose_graph.h for T_map_from * Exp(tau_from), T_map_to * Exp(tau_to), the tangents being jets.
Eigen::Matrix<Jet12, 6, 1> ErrorOfJets(const Sample<Pose3>& sample, RotationError) {
  const JetPose3 from(sample.T_map_from, 0), to(sample.T_map_to, 6);
  const Eigen::Quaternion<Jet12> measured(ToJets(sample.edge.T_from_to.rotation.coeffs()));
  const JetVector measured_translation = ToJets(sample.edge.T_from_to.translation);
  Eigen::Quaternion<Jet12> off = measured.conjugate() * from.rotation.conjugate() * to.rotation;
  if (off.w().a < 0.0L) off.coeffs() = -off.coeffs();
  const JetVector between = from.rotation.conjugate() * JetVector(to.translation - from.translation);
  Eigen::Matrix<Jet12, 6, 1> error;
  error << measured.conjugate() * JetVector(between - measured_translation), off.vec() * Jet12(2.0L);
  return error;
}

struct JetPose2 {
  Jet12 angle, x, y;
  JetPose2(const Pose2& T, int first)
      : angle(static_cast<long double>(T.angle), first + 2), x(T.translation.x()), y(T.translation.y()) {
    const Jet12 rho_x(0.0L, first), rho_y(0.0L, first + 1);
    x += cos(angle) * rho_x - sin(angle) * rho_y;
    y += sin(angle) * rho_x + cos(angle) * rho_y;
  }
};

Eigen::Matrix<Jet12, 3, 1> ErrorOfJets(const Sample<Pose2>& sample, RotationError rotation_error) {
  const JetPose2 from(sample.T_map_from, 0), to(sample.T_map_to, 3);
  const Pose2& Z = sample.edge.T_from_to;
  const Jet12 dx = to.x - from.x, dy = to.y - from.y;
  const Jet12 x = cos(from.angle) * dx + sin(from.angle) * dy - Jet12(Z.translation.x());
  const Jet12 y = cos(from.angle) * dy - sin(from.angle) * dx - Jet12(Z.translation.y());
  const Jet12 measured(Z.angle);
  Jet12 off = to.angle - from.angle - measured;
  off.a = std::remainder(off.a, 2.0L * std::numbers::pi_v<long double>);
  const bool chord = rotation_error == RotationError::kChord;
  return {cos(measured) * x + sin(measured) * y, cos(measured) * y - sin(measured) * x,
          chord ? Jet12(2.0L) * sin(off * Jet12(0.5L)) : off};
}

template <typename Pose>
class RelativePose : public testing::Test {
 protected:
  const std::vector<Sample<Pose>> samples_ = Samples<Pose>();
  const RotationError kinds_[2] = {RotationError::kAngle, RotationError::kChord};
};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(RelativePose, Poses);

TYPED_TEST(RelativePose, HasTheSquaredErrorOfTheGraph) {
  for (const RotationError kind : this->kinds_) {
    for (const auto& sample : this->samples_) {
      const PoseGraph<TypeParam> graph{
          {{0, sample.T_map_from}, {1, sample.T_map_to}}, {sample.edge}, {}, kind};
      const auto factor = MakeRelativePoseFactor(sample.edge, kind);
      const double actual =
          Residuals<TypeParam>(*factor, {sample.T_map_from, sample.T_map_to}).squaredNorm();
      EXPECT_NEAR(actual, SquaredError(graph, graph.edges[0]), 1e-12 * (1.0 + actual));
    }
  }
}

TYPED_TEST(RelativePose, HasTheDerivativesOfAutomaticDifferentiation) {
  constexpr int kDof = TypeParam::kDof;
  for (const RotationError kind : this->kinds_) {
    for (const auto& sample : this->samples_) {
      const LinearError<TypeParam> linear = Linearize(RotatedPose<TypeParam>(sample.edge.T_from_to),
                                                      RotatedPose<TypeParam>(sample.T_map_from),
                                                      RotatedPose<TypeParam>(sample.T_map_to), kind);
      const auto expected = ErrorOfJets(sample, kind);
      for (int row = 0; row < kDof; ++row) {
        const auto v = expected[row].v.template head<2 * kDof>().template cast<double>().eval();
        EXPECT_NEAR(linear.e[row], static_cast<double>(expected[row].a), 1e-13);
        EXPECT_LE((linear.J_from.row(row).transpose() - v.template head<kDof>()).norm(), 2e-13);
        EXPECT_LE((linear.J_to.row(row).transpose() - v.template tail<kDof>()).norm(), 2e-13);
      }
    }
  }
}

TYPED_TEST(RelativePose, HasTheJacobianOfItsResiduals) {
  for (const RotationError kind : this->kinds_) {
    for (const auto& sample : this->samples_) {
      const auto factor = MakeRelativePoseFactor(sample.edge, kind);
      const std::vector<TypeParam> poses = {sample.T_map_from, sample.T_map_to};
      const Eigen::MatrixXd jacobian = Linearize(*factor, poses).jacobian;
      EXPECT_LE((jacobian - CentralDifferences(*factor, poses)).norm(), 1e-7 * (1.0 + jacobian.norm()));
    }
  }
}

TYPED_TEST(RelativePose, LetsOneSideBeConstant) {
  const auto& sample = this->samples_.back();
  const auto factor = MakeRelativePoseFactor(sample.edge, RotationError::kAngle);
  const auto from = ToBlock(sample.T_map_from), to = ToBlock(sample.T_map_to);
  const double* const parameters[] = {from.data(), to.data()};
  const Linearized whole = Linearize<TypeParam>(*factor, {sample.T_map_from, sample.T_map_to});
  Eigen::Matrix<double, TypeParam::kDof, kBlockSize<TypeParam>, Eigen::RowMajor> by_to;
  double* jacobians[] = {nullptr, by_to.data()};
  typename TypeParam::Tangent residuals;
  ASSERT_TRUE(factor->Evaluate(parameters, residuals.data(), jacobians));
  EXPECT_EQ(by_to.template leftCols<TypeParam::kDof>(), whole.jacobian.rightCols(TypeParam::kDof));
}

TYPED_TEST(RelativePose, PriorIsTheEdgeFromTheMapsOrigin) {
  for (const RotationError kind : this->kinds_) {
    for (const auto& sample : this->samples_) {
      const PosePrior<TypeParam> prior{0, sample.edge.T_from_to, sample.edge.information};
      const TypeParam T_map_node = sample.T_map_from.Inverse() * sample.T_map_to;
      const PoseGraph<TypeParam> graph{{{0, T_map_node}}, {}, {prior}, kind};
      const auto factor = MakePriorFactor(prior, kind);
      const Linearized linearized = Linearize<TypeParam>(*factor, {T_map_node});
      EXPECT_NEAR(linearized.Cost(), Objective(graph), 1e-12 * (1.0 + linearized.Cost()));
      EXPECT_LE((linearized.jacobian - CentralDifferences<TypeParam>(*factor, {T_map_node})).norm(),
                1e-7 * (1.0 + linearized.jacobian.norm()));
    }
  }
}

TYPED_TEST(RelativePose, TakesInformationThatLeavesDirectionsFree) {
  using Tangent = typename TypeParam::Tangent;
  RandomStream stream = NamedStream(1, "relative_pose_test/rank");
  for (int rank = 0; rank <= TypeParam::kDof; ++rank) {
    typename TypeParam::Square information = TypeParam::Square::Zero();
    for (int k = 0; k < rank; ++k) {
      const Tangent direction = RandomDirection<TypeParam::kDof>(stream);
      information += std::pow(10.0, k) * direction * direction.transpose();
    }
    const auto root = RootOfInformation<TypeParam>(information);
    EXPECT_LE((root.transpose() * root - information).norm(), 1e-13 * information.norm());
  }
}

TYPED_TEST(RelativePose, SaysThatInformationIsIndefinite) {
  auto edge = this->samples_.front().edge;
  edge.information = TypeParam::Square::Identity();
  edge.information(0, 0) = -0.1;
  EXPECT_THAT(ErrorOf([&] { MakeRelativePoseFactor(edge, RotationError::kAngle); }),
              testing::HasSubstr("is not positive semidefinite"));
  edge.information(0, 0) = std::nan("");
  EXPECT_THAT(ErrorOf([&] { MakeRelativePoseFactor(edge, RotationError::kAngle); }),
              testing::HasSubstr("not finite"));
}

TYPED_TEST(RelativePose, SwitchScalesResidualsAndHasTheirJacobian) {
  constexpr int kSize = TypeParam::kDof;
  using Rows = Eigen::Matrix<double, kSize, kBlockSize<TypeParam>, Eigen::RowMajor>;
  for (const double x : {0.0, 0.3, 1.0}) {
    const auto& sample = this->samples_[20];
    const std::vector<TypeParam> poses = {sample.T_map_from, sample.T_map_to};
    const Linearized plain = Linearize(*MakeRelativePoseFactor(sample.edge, RotationError::kChord), poses);
    const auto factor = MakeSwitchableFactor(sample.edge, RotationError::kChord);
    const auto from = ToBlock(poses[0]), to = ToBlock(poses[1]);
    const double* const parameters[] = {from.data(), to.data(), &x};
    Rows by_from, by_to;
    typename TypeParam::Tangent residuals, by_switch;
    double* jacobians[] = {by_from.data(), by_to.data(), by_switch.data()};
    ASSERT_TRUE(factor->Evaluate(parameters, residuals.data(), jacobians));
    EXPECT_LE((residuals - x * plain.residuals).norm(), 1e-15 * plain.residuals.norm());
    EXPECT_EQ(by_switch, plain.residuals);
    EXPECT_LE((by_from.template leftCols<kSize>() - x * plain.jacobian.leftCols(kSize)).norm(), 1e-12);
    EXPECT_LE((by_to.template leftCols<kSize>() - x * plain.jacobian.rightCols(kSize)).norm(), 1e-12);
  }
}

TYPED_TEST(RelativePose, ManifoldPerturbsOnTheRight) {
  const PoseManifold<TypeParam> manifold;
  RandomStream stream = NamedStream(1, "relative_pose_test/manifold");
  for (const TypeParam& T : SamplePoses<TypeParam>()) {
    const auto tau = TangentWith<TypeParam>(2.0, 1.3, stream);
    const auto x = ToBlock(T);
    PoseBlock<TypeParam> y;
    typename TypeParam::Tangent back;
    ASSERT_TRUE(manifold.Plus(x.data(), tau.data(), y.data()));
    ASSERT_TRUE(manifold.Minus(y.data(), x.data(), back.data()));
    EXPECT_THAT(FromBlock<TypeParam>(y.data()), NearPose(T * TypeParam::Exp(tau), 1e-14));
    EXPECT_LE((back - tau).norm(), 1e-12 * (1.0 + T.translation.norm()));
  }
}

TYPED_TEST(RelativePose, ManifoldTakesTheFirstColumnsOfAJacobian) {
  const PoseManifold<TypeParam> manifold;
  constexpr int kAmbient = kBlockSize<TypeParam>, kDof = TypeParam::kDof;
  using Plus = Eigen::Matrix<double, kAmbient, kDof, Eigen::RowMajor>;
  const Eigen::Matrix<double, 4, kAmbient, Eigen::RowMajor> ambient =
      Eigen::VectorXd::LinSpaced(4 * kAmbient, 1.0, 9.0).reshaped(4, kAmbient);
  const auto x = ToBlock(TypeParam());
  Plus plus;
  Eigen::Matrix<double, 4, kDof, Eigen::RowMajor> tangent;
  ASSERT_TRUE(manifold.PlusJacobian(x.data(), plus.data()));
  ASSERT_TRUE(manifold.RightMultiplyByPlusJacobian(x.data(), 4, ambient.data(), tangent.data()));
  EXPECT_EQ(tangent, ambient.template leftCols<kDof>());
  EXPECT_EQ(ambient * plus, tangent);
}

TEST(SwitchPrior, CostsItsWeightWhereTheEdgeIsOff) {
  const auto prior = MakeSwitchPrior(3.0);
  for (const double x : {0.0, 0.25, 1.0}) {
    const double* const parameters[] = {&x};
    double residual = 0.0, derivative = 0.0;
    double* jacobians[] = {&derivative};
    ASSERT_TRUE(prior->Evaluate(parameters, &residual, jacobians));
    EXPECT_DOUBLE_EQ(residual, 3.0 * (1.0 - x));
    EXPECT_DOUBLE_EQ(derivative, -3.0);
  }
}

}  // namespace
}  // namespace ariadne::slam
