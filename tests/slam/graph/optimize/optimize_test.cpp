#include "slam/graph/optimize/optimize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "slam/graph/isotropic.h"
#include "slam/graph/optimize/certificate.h"
#include "slam/graph/optimize/covariance.h"
#include "slam/graph/simulated_graph.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

using testing::HasSubstr;

template <typename Pose>
double WorstTranslation(const PoseGraph<Pose>& graph, const std::vector<Pose>& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    worst = std::max(worst, (graph.nodes[i].T_map_node.translation - truth[i].translation).norm());
  return worst;
}

template <typename Pose>
double RmsTranslation(const PoseGraph<Pose>& graph, const std::vector<Pose>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum += (graph.nodes[i].T_map_node.translation - truth[i].translation).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

SimulatedGraphOptions Walk(int poses) {
  SimulatedGraphOptions options;
  options.poses = poses;
  return options;
}

template <typename Pose>
class OptimizeTest : public testing::Test {};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(OptimizeTest, Poses);

TYPED_TEST(OptimizeTest, FindsTheTruthOfMeasurementsWithoutNoise) {
  SimulatedGraphOptions options = Walk(60);
  options.translation_noise = options.rotation_noise = 0.0;
  const SimulatedGraph<TypeParam> simulated = SimulateGraph<TypeParam>(options, 1);
  for (const GraphStart start : {GraphStart::kChordal, GraphStart::kGuess, GraphStart::kOdometry}) {
    GraphOptions graph;
    graph.start = start;
    const OptimizeResult<TypeParam> result = Optimize(simulated.graph, graph);
    EXPECT_EQ(result.status, GraphStatus::kConverged);
    EXPECT_LT(WorstTranslation(result.graph, simulated.truth), 1e-9);
  }
}

TYPED_TEST(OptimizeTest, EndsWhereCeresEnds) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SimulatedGraph<TypeParam> simulated = SimulateGraph<TypeParam>(Walk(80), seed);
    for (const bool isotropic : {false, true}) {
      const PoseGraph<TypeParam> graph = isotropic ? Isotropic(simulated.graph) : simulated.graph;
      GraphOptions own, ceres;
      own.convergence = ceres.convergence = 1e-14;
      ceres.solver = GraphSolver::kCeres;
      const auto a = Optimize(graph, own), b = Optimize(graph, ceres);
      EXPECT_NEAR(a.objective, b.objective, 1e-8 * b.objective);
      for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        EXPECT_LT(
            (a.graph.nodes[i].T_map_node.translation - b.graph.nodes[i].T_map_node.translation).norm(),
            1e-6);
    }
  }
}

TYPED_TEST(OptimizeTest, DoesNotDependOnTheFrameOfTheMap) {
  using Pose = TypeParam;
  const SimulatedGraph<Pose> simulated = SimulateGraph<Pose>(Walk(50), 4);
  const Pose T_other_map = Pose::Exp(Pose::Tangent::LinSpaced(0.5, 2.0));
  PoseGraph<Pose> moved = simulated.graph;
  for (PoseNode<Pose>& node : moved.nodes) node.T_map_node = T_other_map * node.T_map_node;
  for (const GraphStart start : {GraphStart::kChordal, GraphStart::kGuess}) {
    GraphOptions options;
    options.start = start;
    const auto a = Optimize(simulated.graph, options), b = Optimize(moved, options);
    EXPECT_NEAR(a.objective, b.objective, 1e-7 * a.objective);
    for (std::size_t i = 0; i < moved.nodes.size(); ++i) {
      EXPECT_LT(((T_other_map * a.graph.nodes[i].T_map_node).translation -
                 b.graph.nodes[i].T_map_node.translation)
                    .norm(),
                1e-5);
    }
  }
}

TYPED_TEST(OptimizeTest, CovariancesAreHonest) {
  using Pose = TypeParam;
  double nees = 0.0, relative = 0.0;
  constexpr int kGraphs = 100;
  for (std::uint64_t seed = 0; seed < kGraphs; ++seed) {
    const SimulatedGraph<Pose> simulated = SimulateGraph<Pose>(Walk(30), seed);
    const auto result = Optimize(simulated.graph, {});
    const auto covariances = MarginalCovariances(result.graph, {{10, 20}});
    const auto error = [&](const Pose& estimate, const Pose& truth) ->
        typename Pose::Tangent { return (estimate.Inverse() * truth).Log(); };
    const auto& nodes = result.graph.nodes;
    const auto last = error(nodes.back().T_map_node, simulated.truth.back());
    nees += last.dot(covariances.nodes.back().inverse() * last) / kGraphs;
    const auto between = error(nodes[10].T_map_node.Inverse() * nodes[20].T_map_node,
                               simulated.truth[10].Inverse() * simulated.truth[20]);
    relative += between.dot(covariances.pairs[0].inverse() * between) / kGraphs;
  }
  // The mean of 100 chi-squares lies within three of its standard deviations.
  const double dof = Pose::kDof, deviation = std::sqrt(2.0 * dof / kGraphs);
  EXPECT_NEAR(nees, dof, 3.0 * deviation);
  EXPECT_NEAR(relative, dof, 3.0 * deviation);
}

TYPED_TEST(OptimizeTest, WrongClosuresDoNotBendTheMapWithGncButDoWithout) {
  SimulatedGraphOptions right = Walk(150), wrong = right;
  wrong.wrong_closures = 0.3;
  int recovered = 0, bent = 0;
  constexpr int kSeeds = 20;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto clean = SimulateGraph<TypeParam>(right, seed),
               spoiled = SimulateGraph<TypeParam>(wrong, seed);
    const double reference = RmsTranslation(Optimize(clean.graph, {}).graph, clean.truth);
    GraphOptions gnc;
    gnc.robust = GraphRobust::kGnc;
    if (RmsTranslation(Optimize(spoiled.graph, gnc).graph, spoiled.truth) <= 2.0 * reference) ++recovered;
    if (RmsTranslation(Optimize(spoiled.graph, {}).graph, spoiled.truth) > 2.0 * reference) ++bent;
  }
  EXPECT_GE(recovered, 19);
  EXPECT_EQ(bent, kSeeds);
}

TYPED_TEST(OptimizeTest, PriorsHoldAGraphWithoutFixedNodes) {
  SimulatedGraph<TypeParam> simulated = SimulateGraph<TypeParam>(Walk(30), 3);
  simulated.graph.nodes[0].fixed = false;
  simulated.graph.priors.push_back({5, simulated.truth[5]});
  const auto result = Optimize(simulated.graph, {});
  EXPECT_EQ(result.status, GraphStatus::kConverged);
  EXPECT_LT((result.graph.nodes[5].T_map_node.translation - simulated.truth[5].translation).norm(), 1e-6);
}

TYPED_TEST(OptimizeTest, MeasurementsWithoutNoiseAreProvenByTheirZero) {
  SimulatedGraphOptions options = Walk(40);
  options.translation_noise = options.rotation_noise = 0.0;
  const PoseGraph<TypeParam> graph = Isotropic(SimulateGraph<TypeParam>(options, 2).graph);
  EXPECT_EQ(Certify(Optimize(graph, {}).graph).verdict, CertificateVerdict::kOptimal);
  GraphOptions gnc;
  gnc.robust = GraphRobust::kGnc;
  EXPECT_EQ(Optimize(graph, gnc).status, GraphStatus::kConverged);
}

TYPED_TEST(OptimizeTest, CertifiesTheMinimum) {
  const SimulatedGraph<TypeParam> simulated = SimulateGraph<TypeParam>(Walk(100), 5);
  const PoseGraph<TypeParam> graph = Isotropic(simulated.graph);
  const auto result = Optimize(graph, {});
  const Certificate certificate = Certify(result.graph);
  EXPECT_EQ(certificate.verdict, CertificateVerdict::kOptimal) << certificate.message;
  EXPECT_LE(certificate.lower_bound, result.objective);
  EXPECT_GE(certificate.lower_bound, (1.0 - 1e-6) * result.objective);
}

/// Poses on a circle, each measured a turn after the one before, started wound up once too often: a local
/// minimum in which every edge is a little wrong.
TEST(Certify, SaysThatALocalMinimumIsNotCertified) {
  constexpr int kPoses = 24;
  PoseGraph2 graph;
  const double turn = 2.0 * 3.14159265358979 / kPoses;
  for (int i = 0; i < kPoses; ++i)
    graph.nodes.push_back({i, Pose2::Exp({0.0, 0.0, 2.0 * turn * i}), i == 0});
  for (std::size_t i = 0; i < kPoses; ++i)
    graph.edges.push_back(
        {i, (i + 1) % kPoses, Pose2{turn, Eigen::Vector2d(1.0, 0.0)}, Pose2::Square::Identity()});
  graph = Isotropic(graph);
  for (auto& edge : graph.edges) edge.information(2, 2) = 1e4;  // so that only the turns matter
  GraphOptions guess;
  guess.start = GraphStart::kGuess;
  const auto wound = Optimize(graph, guess), right = Optimize(graph, {});
  ASSERT_GT(wound.objective, 10.0 + right.objective);
  EXPECT_EQ(Certify(wound.graph).verdict, CertificateVerdict::kNotCertified);
  EXPECT_LE(Certify(wound.graph).lower_bound, right.objective + 1e-6);
}

TEST(Optimize, IndefiniteInformationEndsInASentence) {
  SimulatedGraph<Pose3> simulated = SimulateGraph<Pose3>(Walk(30), 6);
  for (auto& edge : simulated.graph.edges) edge.information(0, 0) = -1.0;
  const auto result = Optimize(simulated.graph, {});
  EXPECT_EQ(result.status, GraphStatus::kFailed);
  EXPECT_THAT(result.message, HasSubstr("not positive definite"));
}

TEST(Optimize, RefusesPiecesAndOptionsOutOfRange) {
  SimulatedGraph<Pose2> simulated = SimulateGraph<Pose2>(Walk(30), 7);
  GraphOptions options;
  options.max_iterations = 0;
  EXPECT_THAT(ErrorOf([&] { Optimize(simulated.graph, options); }), HasSubstr("graph.max_iterations"));
  simulated.graph.nodes.push_back({1000, Pose2(), false});
  EXPECT_THAT(ErrorOf([&] { Optimize(simulated.graph, {}); }), HasSubstr("1000"));
}

}  // namespace
}  // namespace ariadne::slam
