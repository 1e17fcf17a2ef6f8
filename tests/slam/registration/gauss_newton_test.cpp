#include "slam/registration/gauss_newton.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <string>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using Tangent = Pose3::Tangent;
using Jacobian = Eigen::Matrix<double, 3, 6>;

/// Random points with random normals, of which every fifth has no pair.
class PlaneEquations : public testing::TestWithParam<Metric> {
 protected:
  PlaneEquations() {
    for (std::size_t i = 0; i < model_.size(); ++i) {
      model_surfaces_.push_back({DrawDirection(stream_), false, 0.1});
      data_surfaces_.push_back({DrawDirection(stream_), false, 0.1});
      const auto partner = static_cast<std::uint32_t>((7 * i) % model_.size());
      pairs_.model_index.push_back(i % 5 == 0 ? kNoPoint : partner);
      pairs_.squared_distance.push_back(0.0);
    }
  }

  /// e(tau) = R^T (T Translate(center) Exp(tau) Translate(-center) d - m): the difference in the present
  /// data frame.
  Eigen::Vector3d DifferenceAt(const Tangent& tau, std::size_t i) const {
    const Eigen::Vector3d moved = center_ + Pose3::Exp(tau) * (data_[i] - center_);
    return T_.RotationMatrix().transpose() * (T_ * moved - model_[pairs_.model_index[i]]);
  }

  Jacobian NumericJacobian(std::size_t i) const {
    constexpr double kStep = 1e-6;
    Jacobian J;
    for (int k = 0; k < 6; ++k) {
      const Tangent step = kStep * Tangent::Unit(k);
      J.col(k) = (DifferenceAt(step, i) - DifferenceAt(-step, i)) / (2.0 * kStep);
    }
    return J;
  }

  NormalEquations Gather(const PairWeight& weight, int threads = 1) const {
    return GatherNormalEquations(metric_, pairs_, T_, center_, weight, Parallel(threads));
  }

  RandomStream stream_ = NamedStream(1, "gauss_newton_test");
  const std::vector<Eigen::Vector3d> model_ = DrawCloud(stream_, 1500, 2.0);
  const std::vector<Eigen::Vector3d> data_ = DrawCloud(stream_, 1500, 2.0);
  const Pose3 T_ = DrawMotion(stream_, 1.0, 2.0);
  const Eigen::Vector3d center_{0.3, -0.7, 0.4};
  std::vector<SurfacePoint> model_surfaces_, data_surfaces_;
  Correspondences pairs_;
  const PlaneMetric metric_{model_, model_surfaces_, data_, data_surfaces_, GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Metrics, PlaneEquations,
                         testing::Values(Metric::kPointToPlane, Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(PlaneEquations, AreThoseOfNumericDerivatives) {
  const PairWeight weight = ChooseWeight({}, 1.0, RobustKernel::kCauchy, 0.5);
  NormalEquations expected;
  for (std::size_t i = 0; i < data_.size(); ++i) {
    if (pairs_.model_index[i] == kNoPoint) continue;
    const PairError error = metric_.Error(i, pairs_.model_index[i], T_, T_.RotationMatrix().transpose());
    const double w = weight(error.Squared());
    const Jacobian J = NumericJacobian(i);
    expected.H += w * J.transpose() * error.Information() * J;
    expected.g += w * J.transpose() * error.Information() * DifferenceAt(Tangent::Zero(), i);
    expected.sum_squared += w * error.Squared();
    expected.weight += w;
    ++expected.pairs;
  }
  const NormalEquations equations = Gather(weight);
  EXPECT_THAT(equations.H, NearMatrix(expected.H, 1e-7 * expected.H.norm()));
  EXPECT_THAT(equations.g, NearMatrix(expected.g, 1e-7 * expected.g.norm()));
  EXPECT_NEAR(equations.sum_squared, expected.sum_squared, 1e-10 * expected.sum_squared);
  EXPECT_NEAR(equations.weight, expected.weight, 1e-10 * expected.weight);
  EXPECT_EQ(equations.pairs, 1200u);
}

TEST_P(PlaneEquations, CountOnlyPairsWithWeight) {
  const PairWeight weight = ChooseWeight({}, 1.0, RobustKernel::kTukey, 0.5);
  const std::vector<double> squared = SquaredResiduals(metric_, pairs_, T_);
  EXPECT_EQ(squared.size(), 1200u);
  const auto within = std::ranges::count_if(squared, [](double r2) { return r2 < 0.25; });
  EXPECT_GT(within, 0);
  EXPECT_LT(within, 1200);
  EXPECT_EQ(Gather(weight).pairs, static_cast<std::size_t>(within));
}

TEST_P(PlaneEquations, HaveTheSameBytesOnAnyNumberOfThreads) {
  const NormalEquations serial = Gather({});
  for (const int threads : {2, 3}) {
    const NormalEquations parallel = Gather({}, threads);
    EXPECT_EQ(parallel.H, serial.H);
    EXPECT_EQ(parallel.g, serial.g);
  }
}

TEST_P(PlaneEquations, LeadToASmallerError) {
  const NormalEquations before = Gather({});
  const Tangent step = SolveStep(before, 2.0);
  const Pose3 better = T_ * ExpAbout(center_, 0.1 * step);
  const NormalEquations after = GatherNormalEquations(metric_, pairs_, better, center_, {}, Parallel(1));
  EXPECT_LT(after.sum_squared, before.sum_squared);
}

/// H of the given rank, with g in its range.
NormalEquations EquationsOfRank(int rank, RandomStream& stream) {
  NormalEquations equations;
  for (int i = 0; i < rank; ++i) {
    Tangent j;
    for (double& x : j) x = DrawNormal(stream, 0.0, 1.0);
    equations.H += j * j.transpose();
    equations.g += DrawNormal(stream, 0.0, 1.0) * j;
  }
  return equations;
}

TEST(SolveStep, SolvesRegularEquations) {
  RandomStream stream = NamedStream(1, "gauss_newton_test/regular");
  for (const double length : {0.1, 1.0, 10.0}) {
    const NormalEquations equations = EquationsOfRank(12, stream);
    EXPECT_THAT(SolveStep(equations, length), NearMatrix(-equations.H.inverse() * equations.g, 1e-10));
  }
}

TEST(SolveStep, TakesTheShortestStepOfSingularEquations) {
  RandomStream stream = NamedStream(1, "gauss_newton_test/singular");
  for (int rank = 0; rank < 6; ++rank) {
    const NormalEquations equations = EquationsOfRank(rank, stream);
    const Tangent step = SolveStep(equations, 1.0);
    EXPECT_THAT(equations.H * step, NearMatrix(-equations.g, 1e-9)) << "rank " << rank;
    const Tangent shortest =
        equations.H.completeOrthogonalDecomposition().solve(-equations.g);  // of minimal norm
    EXPECT_THAT(step, NearMatrix(shortest, 1e-8)) << "rank " << rank;
  }
}

TEST(SolveStep, DoesNotMoveAlongWhatNothingHolds) {
  NormalEquations floor;  // a plane z = const holds z, and turning about x and y
  floor.H.diagonal() << 0.0, 0.0, 100.0, 50.0, 50.0, 0.0;
  floor.g << 0.0, 0.0, 3.0, 1.0, -1.0, 0.0;
  Tangent expected;
  expected << 0.0, 0.0, -0.03, -0.02, 0.02, 0.0;
  EXPECT_THAT(SolveStep(floor, 2.0), NearMatrix(expected, 1e-15));
  floor.g << 1e-14, 0.0, 3.0, 1.0, -1.0, 1e-14;  // and not on rounding errors either
  EXPECT_THAT(SolveStep(floor, 2.0), NearMatrix(expected, 1e-15));
}

TEST(ExpAbout, TurnsAboutTheCenter) {
  RandomStream stream = NamedStream(1, "gauss_newton_test/about");
  const Eigen::Vector3d center = DrawInCube(stream, 10.0);
  const Pose3 to_center{Eigen::Quaterniond::Identity(), center};
  Tangent tau;
  tau << 0.1, -0.2, 0.3, 0.4, 0.5, -0.6;
  EXPECT_THAT(ExpAbout(center, tau), NearPose(to_center * Pose3::Exp(tau) * to_center.Inverse(), 1e-15));
  tau.head<3>().setZero();
  EXPECT_THAT(ExpAbout(center, tau) * center, NearMatrix(center, 1e-14));
}

}  // namespace
}  // namespace ariadne::slam
