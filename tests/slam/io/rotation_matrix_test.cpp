#include "slam/io/rotation_matrix.h"

#include <gtest/gtest.h>

#include <numbers>

#include "slam/base/random.h"

namespace ariadne::slam {
namespace {

Eigen::Quaterniond RandomRotation(RandomStream& stream) {
  Eigen::Vector4d q;
  for (double& component : q) component = DrawNormal(stream, 0.0, 1.0);
  return Eigen::Quaterniond(q).normalized();
}

void ExpectStable(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d R = RotationMatrixForFile(rotation);
  EXPECT_LT((R - rotation.toRotationMatrix()).cwiseAbs().maxCoeff(), 1e-13);
  const auto read = RotationFromMatrix(R);
  ASSERT_TRUE(read.has_value());
  EXPECT_NEAR(read->norm(), 1.0, 1e-15);
  EXPECT_EQ(RotationMatrixForFile(*read), R);
  EXPECT_EQ(RotationFromMatrix(RotationMatrixForFile(*read))->coeffs(), read->coeffs());
}

TEST(RotationMatrix, KeepsItsBits) {
  RandomStream stream = NamedStream(4, "rotation_matrix_test");
  for (int i = 0; i < 100'000; ++i) ExpectStable(RandomRotation(stream));
}

TEST(RotationMatrix, KeepsTheBitsOfCommonAngles) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1),
        Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0, 1, -1)}) {
    for (int steps = -24; steps <= 24; ++steps) {
      const double angle = steps * std::numbers::pi / 12.0;
      ExpectStable(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized())));
    }
  }
}

TEST(RotationMatrix, FindsTheNearestRotation) {
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Matrix3d rounded = (rotation.toRotationMatrix() * 1e4).array().round() / 1e4;
  ASSERT_TRUE(RotationFromMatrix(rounded).has_value());
  EXPECT_LT(RotationFromMatrix(rounded)->angularDistance(rotation), 1e-4);
}

TEST(RotationMatrix, RefusesOtherMatrices) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(RotationFromMatrix(identity * 1.0004).has_value());
  EXPECT_FALSE(RotationFromMatrix(identity * 1.001).has_value());
  EXPECT_FALSE(RotationFromMatrix(-identity).has_value());
  EXPECT_FALSE(RotationFromMatrix(identity * 0.0).has_value());
  EXPECT_FALSE(RotationFromMatrix(identity * std::nan("")).has_value());
}

}  // namespace
}  // namespace ariadne::slam
