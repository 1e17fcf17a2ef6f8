// Exp and Log of Pose2 and Pose3 against the exponential of the matrix, against each other, and by
// differences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unsupported/Eigen/MatrixFunctions>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
class PoseExpLog : public testing::Test {
 protected:
  const std::vector<typename Pose::Tangent> tangents_ = SampleTangents<Pose>();
};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(PoseExpLog, Poses);

TYPED_TEST(PoseExpLog, OracleAgreesWithEigensMatrixExponential) {
  for (const auto& tau : this->tangents_) {
    const auto wedge = Wedge<TypeParam>(tau);
    EXPECT_THAT(ExpByTaylor(wedge), NearMatrix(wedge.template cast<double>().exp().eval(), 1e-12));
  }
}

TYPED_TEST(PoseExpLog, ExpIsTheExponentialOfTheMatrix) {
  for (const auto& tau : this->tangents_) {
    const auto expected = ExpByTaylor(Wedge<TypeParam>(tau));
    const double length = TranslationPart<TypeParam>(tau).norm();
    EXPECT_THAT(ToMatrix(TypeParam::Exp(tau)), NearMatrix(expected, 1.5e-15 * (1.0 + length)))
        << tau.transpose();
  }
}

TYPED_TEST(PoseExpLog, ExpTakesAnglesBeyondPi) {
  RandomStream stream = NamedStream(1, "pose_exp_log_test/beyond");
  for (const double angle : {3.2, 4.0, 2.0 * std::numbers::pi, 7.0, 9.0}) {
    const auto tau = TangentWith<TypeParam>(2.0, angle, stream);
    const TypeParam pose = TypeParam::Exp(tau);
    EXPECT_THAT(ToMatrix(pose), NearMatrix(ExpByTaylor(Wedge<TypeParam>(tau)), 1e-14));
    EXPECT_THAT(TypeParam::Exp(pose.Log()), NearPose(pose, 1e-14));
    EXPECT_LE(RotationPart<TypeParam>(pose.Log()).norm(), std::numbers::pi);
  }
}

TYPED_TEST(PoseExpLog, LogUndoesExpToTheLastDigits) {
  for (const auto& tau : this->tangents_) {
    const typename TypeParam::Tangent error = TypeParam::Exp(tau).Log() - tau;
    EXPECT_LE(TranslationPart<TypeParam>(error).norm(), 4e-15 * TranslationPart<TypeParam>(tau).norm());
    EXPECT_LE(RotationPart<TypeParam>(error).norm(), 2e-15 * RotationPart<TypeParam>(tau).norm());
  }
}

TYPED_TEST(PoseExpLog, ExpUndoesLog) {
  for (const TypeParam& pose : SamplePoses<TypeParam>()) {
    EXPECT_THAT(TypeParam::Exp(pose.Log()), NearPose(pose, 4e-15));
    EXPECT_THAT(TypeParam::Exp(-pose.Log()), NearPose(pose.Inverse(), 4e-15));
  }
}

TYPED_TEST(PoseExpLog, IdentityIsTheZeroTangentExactly) {
  EXPECT_EQ(TypeParam().Log(), TypeParam::Tangent::Zero());
  EXPECT_EQ(ToMatrix(TypeParam::Exp(TypeParam::Tangent::Zero())), Homogeneous<TypeParam>::Identity());
}

TYPED_TEST(PoseExpLog, AreContinuousAcrossEveryBranch) {
  RandomStream stream = NamedStream(1, "pose_exp_log_test/branches");
  for (const double branch : kBranches) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      const auto tau = TangentWith<TypeParam>(branch, branch, stream);
      const TypeParam below = TypeParam::Exp((1.0 - 4e-15) * tau);
      const TypeParam above = TypeParam::Exp((1.0 + 4e-15) * tau);
      EXPECT_LE((above.translation - below.translation).norm(), 2e-14 * branch);
      EXPECT_LE((above.RotationMatrix() - below.RotationMatrix()).norm(), 4e-14 * branch);
      EXPECT_LE((above.Log() - below.Log()).norm(), 2e-14 * branch);
    }
  }
}

// T * Exp(tau) moves a point by T.R * (rho + theta x p): the sign conventions of every Jacobian.
TYPED_TEST(PoseExpLog, PerturbationOnTheRightMovesPointsInTheFrameOnTheRight) {
  constexpr double kStep = 1e-5;
  RandomStream stream = NamedStream(1, "pose_exp_log_test/differences");
  for (const TypeParam& T : SamplePoses<TypeParam>()) {
    const typename TypeParam::Point p = 5.0 * RandomDirection<kDimension<TypeParam>>(stream);
    for (int k = 0; k < TypeParam::kDof; ++k) {
      const typename TypeParam::Tangent unit = TypeParam::Tangent::Unit(k);
      const auto forward = T * TypeParam::Exp(kStep * unit) * p;
      const auto backward = T * TypeParam::Exp(-kStep * unit) * p;
      const Homogeneous<TypeParam> velocity = ToMatrix(T) * Wedge<TypeParam>(unit);
      const auto expected = (velocity.template cast<double>() * p.homogeneous()).eval();
      const typename TypeParam::Point difference = (forward - backward) / (2.0 * kStep);
      EXPECT_THAT(difference, NearMatrix(expected.template head<kDimension<TypeParam>>(), 2e-9));
    }
  }
}

}  // namespace
}  // namespace ariadne::slam
