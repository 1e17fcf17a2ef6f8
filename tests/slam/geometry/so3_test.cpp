#include "slam/geometry/so3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"

namespace ariadne::slam {
namespace {

using Vector3l = Eigen::Matrix<long double, 3, 1>;
using Matrix3l = Eigen::Matrix<long double, 3, 3>;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
const Eigen::Vector3d kUnitX(1.0, 0.0, 0.0);
const Eigen::Vector3d kOblique(1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0);

class So3 : public testing::Test {
 protected:
  So3() {
    RandomStream stream = NamedStream(1, "so3_test");
    for (const double angle : SampleAngles()) {
      for (const Eigen::Vector3d& axis : {kUnitX, kOblique, RandomDirection<3>(stream)}) {
        thetas_.push_back(angle * axis);
      }
    }
  }

  std::vector<Eigen::Vector3d> thetas_;
};

Matrix3l HatL(const Vector3l& a) {
  Matrix3l hat;
  hat << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return hat;
}

/// The left Jacobian is the sum of Hat(theta)^k / (k + 1)!.
Matrix3l LeftJacobianByTaylor(const Eigen::Vector3d& theta) {
  const Matrix3l hat = HatL(theta.cast<long double>());
  Matrix3l term = Matrix3l::Identity();
  Matrix3l sum = term;
  for (int k = 1; k <= 40; ++k) {
    term = (term * hat / (k + 1)).eval();
    sum += term;
  }
  return sum;
}

TEST_F(So3, HatIsTheCrossProduct) {
  const Eigen::Vector3d a(1.0, 2.0, 3.0);
  const Eigen::Vector3d b(-4.0, 0.5, 7.0);
  EXPECT_EQ(Hat(a) * b, a.cross(b));
  EXPECT_EQ(Hat(a).transpose(), -Hat(a));
}

TEST_F(So3, ExpTurnsByTheRightHandRule) {
  const Eigen::Vector3d quarter_about_z(0.0, 0.0, std::numbers::pi / 2.0);
  EXPECT_THAT(ExpSo3(quarter_about_z) * Eigen::Vector3d::UnitX(),
              NearMatrix(Eigen::Vector3d::UnitY(), 1e-15));
}

TEST_F(So3, ExpIsExactToRounding) {
  for (const Eigen::Vector3d& theta : thetas_) {
    const Vector3l exact = theta.cast<long double>();
    const long double angle = exact.norm();
    const Vector3l vec = angle > 0.0L ? Vector3l(std::sin(angle / 2) / angle * exact) : Vector3l(exact / 2);
    const Eigen::Quaterniond rotation = ExpSo3(theta);
    EXPECT_THAT(rotation.vec(), NearMatrix(vec, 2.0 * kEpsilon * static_cast<double>(vec.norm()))) << angle;
    EXPECT_NEAR(rotation.w(), static_cast<double>(std::cos(angle / 2)), kEpsilon);
    EXPECT_NEAR(rotation.norm(), 1.0, kEpsilon);
  }
}

TEST_F(So3, LogIsExactToRounding) {
  for (const Eigen::Vector3d& theta : thetas_) {
    const Eigen::Quaterniond rotation = ExpSo3(theta);
    const Vector3l vec = rotation.vec().cast<long double>();
    const long double sine = vec.norm();
    const long double angle = 2.0L * std::atan2(sine, static_cast<long double>(rotation.w()));
    const Vector3l exact = sine > 0.0L ? Vector3l(angle / sine * vec) : vec;
    EXPECT_THAT(LogSo3(rotation), NearMatrix(exact, 2.0 * kEpsilon * static_cast<double>(angle))) << angle;
    EXPECT_THAT(LogSo3(rotation), NearMatrix(theta, 4.0 * kEpsilon * theta.norm())) << angle;
  }
}

TEST_F(So3, LogTakesTheShortWayForBothSignsOfTheQuaternion) {
  for (const Eigen::Vector3d& theta : thetas_) {
    const Eigen::Quaterniond rotation = ExpSo3(theta);
    const Eigen::Quaterniond opposite(-rotation.coeffs());
    EXPECT_EQ(LogSo3(opposite), LogSo3(rotation));
    EXPECT_EQ(LogSo3(rotation.conjugate()), -LogSo3(rotation));
  }
  const Eigen::Vector3d beyond_pi(0.0, 0.0, 1.2 * std::numbers::pi);
  EXPECT_THAT(LogSo3(ExpSo3(beyond_pi)),
              NearMatrix(Eigen::Vector3d(0.0, 0.0, -0.8 * std::numbers::pi), 1e-15));
}

TEST_F(So3, LogOfAHalfTurnIsPiAboutTheAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  const Eigen::Quaterniond half_turn(0.0, axis.x(), axis.y(), axis.z());
  EXPECT_THAT(LogSo3(half_turn), NearMatrix(std::numbers::pi * axis, 1e-15));
}

TEST_F(So3, LogDoesNotNeedAUnitQuaternion) {
  for (const Eigen::Vector3d& theta : thetas_) {
    const Eigen::Quaterniond longer((1.0 + 1e-9) * ExpSo3(theta).coeffs());
    EXPECT_THAT(LogSo3(longer), NearMatrix(theta, 4.0 * kEpsilon * theta.norm()));
  }
}

TEST_F(So3, LeftJacobianIsExactToRounding) {
  for (const Eigen::Vector3d& theta : thetas_) {
    const Matrix3l exact = LeftJacobianByTaylor(theta);
    EXPECT_THAT(LeftJacobianSo3(theta), NearMatrix(exact, 3.0 * kEpsilon)) << theta.norm();
    EXPECT_THAT(InverseLeftJacobianSo3(theta), NearMatrix(exact.inverse(), 4.0 * kEpsilon)) << theta.norm();
  }
}

/// The three sums across the diagonal, to which only Hat(theta)^2 contributes.
template <typename Matrix>
Eigen::Matrix<typename Matrix::Scalar, 3, 1> SecondOrderPart(const Matrix& J) {
  return {J(0, 1) + J(1, 0), J(0, 2) + J(2, 0), J(1, 2) + J(2, 1)};
}

// Near the branch the second order is so small that it could hide a wrong coefficient or digits lost to
// cancellation, so it is looked at relative to its own size.
TEST_F(So3, LeftJacobiansHaveTheirSecondOrderPartOnBothSidesOfTheBranch) {
  for (const double angle : {1e-5, 1e-4, 0.9e-3, 0.999e-3, 1.001e-3, 1.1e-3}) {
    const Eigen::Vector3d theta = angle * kOblique;
    const Matrix3l exact = LeftJacobianByTaylor(theta);
    const double tolerance = 1e-9 * angle * angle;
    EXPECT_THAT(SecondOrderPart(LeftJacobianSo3(theta)), NearMatrix(SecondOrderPart(exact), tolerance));
    EXPECT_THAT(SecondOrderPart(InverseLeftJacobianSo3(theta)),
                NearMatrix(SecondOrderPart(Matrix3l(exact.inverse())), tolerance));
  }
}

TEST_F(So3, AllFunctionsAreContinuousAcrossTheirBranches) {
  for (const double branch : kBranches) {
    for (const Eigen::Vector3d& axis : {kUnitX, kOblique}) {
      const Eigen::Vector3d below = branch * (1.0 - 4.0 * kEpsilon) * axis;
      const Eigen::Vector3d above = branch * (1.0 + 4.0 * kEpsilon) * axis;
      const double step = 1e-14 * branch;
      EXPECT_THAT(ExpSo3(above).coeffs(), NearMatrix(ExpSo3(below).coeffs(), step));
      EXPECT_THAT(LogSo3(ExpSo3(above)), NearMatrix(LogSo3(ExpSo3(below)), step));
      EXPECT_THAT(LeftJacobianSo3(above), NearMatrix(LeftJacobianSo3(below), 4.0 * kEpsilon));
      EXPECT_THAT(InverseLeftJacobianSo3(above), NearMatrix(InverseLeftJacobianSo3(below), 4.0 * kEpsilon));
    }
  }
}

TEST_F(So3, LeftJacobianIsTheDerivativeOfExp) {
  constexpr double kStep = 1e-5;
  for (const Eigen::Vector3d& theta : thetas_) {
    Eigen::Matrix3d differences;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(k);
      const Eigen::Quaterniond step = ExpSo3(theta + d) * ExpSo3(theta - d).conjugate();
      differences.col(k) = LogSo3(step) / (2.0 * kStep);
    }
    EXPECT_THAT(LeftJacobianSo3(theta), NearMatrix(differences, 1e-9)) << theta.norm();
  }
}

TEST_F(So3, InverseLeftJacobianUndoesTheLeftJacobian) {
  for (const Eigen::Vector3d& theta : thetas_) {
    EXPECT_THAT(InverseLeftJacobianSo3(theta) * LeftJacobianSo3(theta),
                NearMatrix(Eigen::Matrix3d::Identity(), 1e-15));
    EXPECT_THAT(LeftJacobianSo3(theta) * theta, NearMatrix(theta, 1e-15 * theta.norm()))
        << "theta is its axis";
  }
}

}  // namespace
}  // namespace ariadne::slam
