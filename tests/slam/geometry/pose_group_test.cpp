// Properties that make Pose2 and Pose3 groups of rigid motions, run for both types on the same samples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

constexpr double kRounding = 2e-14;  // of a handful of operations, relative to the lengths involved

template <typename Pose>
class PoseGroup : public testing::Test {
 protected:
  /// Calls f(a, b, c) so that every sample meets others of all sizes.
  template <typename Function>
  void ForTriples(const Function& f) const {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      f(poses_[i], poses_[(7 * i + 3) % poses_.size()], poses_[(11 * i + 5) % poses_.size()]);
    }
  }

  const std::vector<Pose> poses_ = SamplePoses<Pose>();
};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(PoseGroup, Poses);

TYPED_TEST(PoseGroup, IdentityIsTheDefaultAndChangesNothing) {
  const TypeParam identity;
  EXPECT_EQ(ToMatrix(identity), Homogeneous<TypeParam>::Identity());
  for (const TypeParam& pose : this->poses_) {
    EXPECT_THAT(identity * pose, NearPose(pose, kRounding));
    EXPECT_THAT(pose * identity, NearPose(pose, kRounding));
  }
}

TYPED_TEST(PoseGroup, RotationsAreProper) {
  for (const TypeParam& pose : this->poses_) {
    const auto R = pose.RotationMatrix();
    EXPECT_THAT(R * R.transpose(), NearMatrix(decltype(R)::Identity(), 2e-15));
    EXPECT_GT(R.determinant(), 0.0);
  }
}

TYPED_TEST(PoseGroup, CompositionIsTheProductOfMatrices) {
  this->ForTriples([](const TypeParam& a, const TypeParam& b, const TypeParam&) {
    EXPECT_THAT(ToMatrix(a * b), NearMatrix(ToMatrix(a) * ToMatrix(b), 6e-14));
  });
}

TYPED_TEST(PoseGroup, CompositionIsAssociative) {
  this->ForTriples([](const TypeParam& a, const TypeParam& b, const TypeParam& c) {
    EXPECT_THAT((a * b) * c, NearPose(a * (b * c), 30.0 * kRounding));
  });
}

TYPED_TEST(PoseGroup, InverseUndoesFromBothSides) {
  for (const TypeParam& pose : this->poses_) {
    const double tolerance = kRounding * (1.0 + pose.translation.norm());
    EXPECT_THAT(pose * pose.Inverse(), NearPose(TypeParam(), tolerance));
    EXPECT_THAT(pose.Inverse() * pose, NearPose(TypeParam(), tolerance));
    EXPECT_THAT(pose.Inverse().Inverse(), NearPose(pose, kRounding));
  }
}

TYPED_TEST(PoseGroup, ActionOnPointsAgreesWithComposition) {
  RandomStream stream = NamedStream(1, "pose_group_test/points");
  this->ForTriples([&](const TypeParam& a, const TypeParam& b, const TypeParam&) {
    const typename TypeParam::Point p = 5.0 * RandomDirection<kDimension<TypeParam>>(stream);
    const Homogeneous<TypeParam> matrix = ToMatrix(a);
    EXPECT_THAT((a * p).homogeneous(),
                NearMatrix(matrix * p.template cast<long double>().homogeneous(), 1e-14));
    EXPECT_THAT((a * b) * p, NearMatrix(a * (b * p), 70 * kRounding));
    EXPECT_THAT(a.Inverse() * (a * p), NearMatrix(p, 40 * kRounding));
  });
}

TYPED_TEST(PoseGroup, LongChainsStayRigid) {
  TypeParam chain;
  for (int repeat = 0; repeat < 100; ++repeat) {
    for (const TypeParam& pose : this->poses_) chain = chain * pose;
  }
  const auto R = chain.RotationMatrix();
  EXPECT_THAT(R * R.transpose(), NearMatrix(decltype(R)::Identity(), 2e-15));
}

TYPED_TEST(PoseGroup, AdjointIsConjugationOfTheVelocityMatrix) {
  RandomStream stream = NamedStream(1, "pose_group_test/adjoint");
  for (const TypeParam& T : this->poses_) {
    const auto tau = TangentWith<TypeParam>(1.0, 1.0, stream);
    EXPECT_THAT(Wedge<TypeParam>(T.Adjoint() * tau) * ToMatrix(T),
                NearMatrix(ToMatrix(T) * Wedge<TypeParam>(tau), 1e-13));
  }
}

TYPED_TEST(PoseGroup, AdjointMovesAPerturbationFromRightToLeft) {
  const auto tangents = SampleTangents<TypeParam>();
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const TypeParam& T = this->poses_[(7 * i + 3) % this->poses_.size()];
    EXPECT_THAT(T * TypeParam::Exp(tangents[i]),
                NearPose(TypeParam::Exp(T.Adjoint() * tangents[i]) * T, 30 * kRounding));
  }
}

TYPED_TEST(PoseGroup, AdjointIsAHomomorphism) {
  this->ForTriples([](const TypeParam& a, const TypeParam& b, const TypeParam&) {
    EXPECT_THAT((a * b).Adjoint(), NearMatrix(a.Adjoint() * b.Adjoint(), 1e-13));
    EXPECT_THAT(a.Inverse().Adjoint() * a.Adjoint(), NearMatrix(TypeParam::Square::Identity(), 1e-13));
  });
}

}  // namespace
}  // namespace ariadne::slam
