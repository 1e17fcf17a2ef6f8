// The guess as a part of what is made small: what surfaces do not hold stays there.
#include "slam/registration/guess_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "slam/registration/align.h"
#include "slam/registration/gauss_newton.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

double SumSquared(const GuessPairs& pairs, const Pose3& T_model_data) {
  double sum = 0.0;
  for (std::size_t k = 0; k < pairs.data.size(); ++k)
    sum += (pairs.model[k] - T_model_data * pairs.data[k]).squaredNorm();
  return sum;
}

TEST(PairsOfGuess, GrowAlikeInAllDirections) {
  RandomStream stream = NamedStream(1, "guess_pairs_test");
  const double length = 3.0;
  for (int i = 0; i < 50; ++i) {
    const Pose3 guess = DrawMotion(stream, 10.0, 3.0);
    const GuessPairs pairs = PairsOfGuess(guess, length);
    EXPECT_NEAR(SumSquared(pairs, guess), 0.0, 1e-20);
    const Eigen::Vector3d way = DrawInBall(stream, 2.0), turn = DrawInBall(stream, 1e-3);
    EXPECT_NEAR(SumSquared(pairs, guess * Pose3{Eigen::Quaterniond::Identity(), way}),
                6.0 * way.squaredNorm(), 1e-12);
    EXPECT_NEAR(SumSquared(pairs, guess * Pose3{ExpSo3(turn), Eigen::Vector3d::Zero()}),
                4.0 * length * length * turn.squaredNorm(), 1e-10);
  }
}

TEST(AddPointTerm, IsThatOfNumericDerivatives) {
  RandomStream stream = NamedStream(1, "guess_pairs_test/term");
  const Eigen::Vector3d center = DrawInCube(stream, 2.0), d = DrawInCube(stream, 2.0);
  const Eigen::Vector3d e = DrawInCube(stream, 0.5);
  NormalEquations equations;
  AddPointTerm(equations, d - center, e, 0.7);
  Eigen::Matrix<double, 3, 6> J;
  for (int k = 0; k < 6; ++k) {
    const Pose3::Tangent tau = 1e-6 * Pose3::Tangent::Unit(k);
    J.col(k) = (ExpAbout(center, tau) * d - ExpAbout(center, -tau) * d) / 2e-6;
  }
  EXPECT_THAT(equations.H, NearMatrix(0.7 * J.transpose() * J, 1e-8));
  EXPECT_THAT(equations.g, NearMatrix(0.7 * J.transpose() * e, 1e-8));
  EXPECT_EQ(equations.pairs, 0u) << "it is no pair";
  EXPECT_EQ(equations.sum_squared, 0.0);
}

/// A corridor along x without ends, and a board across it at x = `board` [m].
PointCloud CorridorWithBoard(double board, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "guess_pairs_test/corridor");
  PointCloud cloud;
  for (int i = 0; i < 4000; ++i) {
    const double x = DrawUniform(stream, -5.0, 5.0), across = DrawUniform(stream, -1.5, 1.5);
    const double side = i % 2 == 0 ? 1.5 : -1.5;
    if (i % 4 < 2) cloud.positions.emplace_back(x, side, across);
    if (i % 4 >= 2) cloud.positions.emplace_back(x, across, side);
  }
  for (int i = 0; i < 150; ++i)
    cloud.positions.emplace_back(board, DrawUniform(stream, -0.5, 0.5), DrawUniform(stream, -0.5, 0.5));
  return cloud;
}

class HeldToGuess : public testing::TestWithParam<Metric> {
 protected:
  HeldToGuess() { options_.metric = GetParam(); }

  /// The board has been carried on by 15 cm between the two scans: wrong pairs, and nothing against them.
  /// The guess is right along the corridor.
  Pose3 AlignCorridors(double guess_share, const Pose3& T_new_model = {}) const {
    AlignOptions options = options_;
    options.guess_share = guess_share;
    const PointCloud model = Transformed(T_new_model, CorridorWithBoard(2.0, 1));
    return T_new_model.Inverse() *
           Align(model, CorridorWithBoard(2.15, 2), T_new_model * guess_, options).T_model_data;
  }

  AlignOptions options_;
  const Pose3 guess_{ExpSo3({0.0, 0.0, 0.02}), {0.0, 0.05, -0.03}};
};
INSTANTIATE_TEST_SUITE_P(Metrics, HeldToGuess,
                         testing::Values(Metric::kPointToPlane, Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(HeldToGuess, DoesNotFollowFewWrongPairsAlongACorridor) {
  EXPECT_GT(std::abs(AlignCorridors(0.0).translation.x()), 0.1) << "without the guess it does";
  // 3.6 % of the pairs against as much guess meet half way.
  EXPECT_NEAR(AlignCorridors(150.0 / 4150.0).translation.x(), -0.075, 0.02);
  EXPECT_LT(std::abs(AlignCorridors(1.0).translation.x()), 0.01);
}

TEST_P(HeldToGuess, StillFollowsWhatTheSurfacesHold) {
  const Pose3 held = AlignCorridors(0.003);
  EXPECT_LT(std::abs(held.translation.y()), 0.003) << "5 cm in the guess";
  EXPECT_LT(std::abs(held.translation.z()), 0.003) << "3 cm";
  EXPECT_LT(RotationDistance(held, Pose3()), 0.002) << "20 mrad";
}

TEST_P(HeldToGuess, DoesNotDependOnTheModelsFrame) {
  RandomStream stream = NamedStream(1, "guess_pairs_test/frames");
  const Pose3 expected = AlignCorridors(0.01);
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(AlignCorridors(0.01, DrawMotion(stream, 20.0, 3.0)), NearPose(expected, 1e-7));
}

TEST(HeldToGuessByPoints, FixesTheTurnThatALineLeavesOpen) {
  RandomStream stream = NamedStream(1, "guess_pairs_test/line");
  PointCloud line;
  for (int i = 0; i < 100; ++i) line.positions.emplace_back(DrawUniform(stream, -2.0, 2.0), 0.0, 0.0);
  AlignOptions options;
  options.assess = false;
  const Pose3 guess{ExpSo3({0.5, 0.0, 0.0}), {0.0, 0.0, 0.0}};
  EXPECT_EQ(Align(line, line, guess, options).status, AlignStatus::kNotUnique);
  for (const ClosedForm form : {ClosedForm::kQuaternion, ClosedForm::kSvd}) {
    options.closed_form = form;
    options.guess_share = 0.01;
    const AlignResult result = Align(line, line, guess, options);
    EXPECT_EQ(result.status, AlignStatus::kConverged) << result.message;
    EXPECT_THAT(result.T_model_data, NearPose(guess, 1e-9));
    EXPECT_EQ(result.pairs, 100u);
  }
}

}  // namespace
}  // namespace ariadne::slam
