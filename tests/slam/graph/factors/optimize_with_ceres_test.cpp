#include "slam/graph/factors/optimize_with_ceres.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>

#include "slam/base/random.h"
#include "slam/graph/isotropic.h"
#include "slam/graph/kernels.h"
#include "slam/io/g2o.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

constexpr double kSigma = 0.02;  // of each component of a measurement (m, rad)

template <typename Pose>
Pose DrawNoise(RandomStream& stream, double sigma) {
  typename Pose::Tangent tau;
  for (double& x : tau) x = DrawNormal(stream, 0.0, sigma);
  return Pose::Exp(tau);
}

/// Two rounds along the same circle: each node of the second sees the one of the first beside it.
template <typename Pose>
struct Rounds {
  PoseGraph<Pose> graph;  // nodes at the odometry, with the noise of the edges
  std::vector<Pose> truth;
};

template <typename Pose>
Rounds<Pose> MakeRounds(double sigma) {
  constexpr std::size_t kRound = 20;
  RandomStream stream = NamedStream(1, "optimize_with_ceres_test");
  typename Pose::Tangent step = Pose::Tangent::Zero();
  step[0] = 1.0;
  step[Pose::kDof - 1] = 2.0 * std::numbers::pi / kRound;
  Rounds<Pose> rounds;
  const typename Pose::Square information = Pose::Square::Identity() / (kSigma * kSigma);
  const auto add_edge = [&](std::size_t from, std::size_t to) {
    const Pose T_from_to = rounds.truth[from].Inverse() * rounds.truth[to] * DrawNoise<Pose>(stream, sigma);
    rounds.graph.edges.push_back({from, to, T_from_to, information});
  };
  for (std::size_t n = 0; n < 2 * kRound; ++n) {
    rounds.truth.push_back(n == 0 ? Pose() : rounds.truth.back() * Pose::Exp(step));
    Pose guess = rounds.truth.back();
    if (n > 0) {
      add_edge(n - 1, n);
      guess = rounds.graph.nodes.back().T_map_node * rounds.graph.edges.back().T_from_to;
    }
    rounds.graph.nodes.push_back({static_cast<std::int64_t>(n), guess});
  }
  for (std::size_t n = kRound; n < 2 * kRound; ++n) add_edge(n - kRound, n);
  return rounds;
}

template <typename Pose>
double WorstError(const Rounds<Pose>& rounds, const CeresResult<Pose>& result) {
  double worst = 0.0;
  for (std::size_t n = 0; n < rounds.truth.size(); ++n)
    worst = std::max(worst, (result.poses[n].translation - rounds.truth[n].translation).norm());
  return worst;
}

/// An edge across the circle that claims that both ends are one place; returns its index.
template <typename Pose>
std::size_t AddWrongClosure(PoseGraph<Pose>& graph) {
  graph.edges.push_back({2, 12, Pose(), graph.edges.front().information});
  return graph.edges.size() - 1;
}

template <typename Pose>
PoseGraph<Pose> At(PoseGraph<Pose> graph, const std::vector<Pose>& poses) {
  for (std::size_t n = 0; n < poses.size(); ++n) graph.nodes[n].T_map_node = poses[n];
  return graph;
}

template <typename Pose>
class OptimizeWithCeresOf : public testing::Test {};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(OptimizeWithCeresOf, Poses);

TYPED_TEST(OptimizeWithCeresOf, FindsTheTruthWithoutNoise) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(0.0);
  RandomStream stream = NamedStream(1, "optimize_with_ceres_test/guess");
  for (std::size_t n = 1; n < rounds.truth.size(); ++n) {
    auto& T_map_node = rounds.graph.nodes[n].T_map_node;
    T_map_node = T_map_node * DrawNoise<TypeParam>(stream, 0.2);
  }
  const CeresResult<TypeParam> result = OptimizeWithCeres(rounds.graph, {});
  EXPECT_EQ(result.status, CeresStatus::kConverged) << result.message;
  EXPECT_LE(WorstError(rounds, result), 1e-9);
  EXPECT_LE(result.objective, 1e-12);
}

TYPED_TEST(OptimizeWithCeresOf, EndsWhereNoStepLowersTheObjective) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  for (const RotationError kind : {RotationError::kAngle, RotationError::kChord}) {
    rounds.graph.rotation_error = kind;
    const CeresResult<TypeParam> result = OptimizeWithCeres(rounds.graph, {});
    ASSERT_EQ(result.status, CeresStatus::kConverged) << result.message;
    EXPECT_LT(result.objective, 0.5 * Objective(rounds.graph));
    EXPECT_NEAR(result.objectives.front(), Objective(rounds.graph), 1e-9 * result.objectives.front());
    EXPECT_NEAR(result.objectives.back(), result.objective, 1e-9 * result.objective);
    RandomStream stream = NamedStream(1, "optimize_with_ceres_test/steps");
    for (int trial = 0; trial < 50; ++trial) {
      PoseGraph<TypeParam> moved = At(rounds.graph, result.poses);
      for (std::size_t n = 1; n < moved.nodes.size(); ++n)
        moved.nodes[n].T_map_node = moved.nodes[n].T_map_node * DrawNoise<TypeParam>(stream, 1e-5);
      EXPECT_GT(Objective(moved), result.objective);
    }
  }
}

TYPED_TEST(OptimizeWithCeresOf, HoldsFixedNodesElseTheFirstUnlessThereIsAPrior) {
  const Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  const auto moves = [](const PoseGraph<TypeParam>& graph, std::size_t node) {
    const auto poses = OptimizeWithCeres(graph, {}).poses;
    return ToMatrix(poses[node]) != ToMatrix(graph.nodes[node].T_map_node);
  };
  EXPECT_FALSE(moves(rounds.graph, 0));
  EXPECT_TRUE(moves(rounds.graph, 7));
  PoseGraph<TypeParam> fixed = rounds.graph;
  fixed.nodes[7].fixed = fixed.nodes[30].fixed = true;
  EXPECT_TRUE(moves(fixed, 0));
  EXPECT_FALSE(moves(fixed, 7));
  EXPECT_FALSE(moves(fixed, 30));
  PoseGraph<TypeParam> prior = rounds.graph;
  prior.priors.push_back({7, rounds.truth[7]});
  EXPECT_TRUE(moves(prior, 0));
  EXPECT_THAT(OptimizeWithCeres(prior, {}).poses[7], NearPose(rounds.truth[7], 1e-6));
}

TYPED_TEST(OptimizeWithCeresOf, KernelsAndSwitchesStandAWrongClosure) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  const double without = WorstError(rounds, OptimizeWithCeres(rounds.graph, {}));
  const std::size_t wrong = AddWrongClosure(rounds.graph);
  EXPECT_GT(WorstError(rounds, OptimizeWithCeres(rounds.graph, {})), 10.0 * without);
  for (const GraphRobust robust :
       {GraphRobust::kCauchy, GraphRobust::kGemanMcClure, GraphRobust::kDcs, GraphRobust::kSwitchable}) {
    GraphOptions options;
    options.robust = robust;
    options.switch_weight = std::sqrt(SquaredScale(options.robust_confidence, TypeParam::kDof));
    const CeresResult<TypeParam> result = OptimizeWithCeres(rounds.graph, options);
    EXPECT_LE(WorstError(rounds, result), 1.5 * without) << ariadne::NameOf(robust);
    ASSERT_EQ(result.edge_weights.size(), rounds.graph.edges.size());
    EXPECT_LE(result.edge_weights[wrong], 0.01) << ariadne::NameOf(robust);
    EXPECT_EQ(result.edge_weights[0], 1.0) << "odometry is trusted";
  }
}

TYPED_TEST(OptimizeWithCeresOf, SwitchesEndWhereTheirKernelDoes) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  AddWrongClosure(rounds.graph);
  GraphOptions options;
  options.robust = GraphRobust::kSwitchable;
  options.convergence = 1e-14;
  options.switch_weight = std::sqrt(SquaredScale(options.robust_confidence, TypeParam::kDof));
  const CeresResult<TypeParam> switches = OptimizeWithCeres(rounds.graph, options);
  options.robust = GraphRobust::kGemanMcClure;
  const CeresResult<TypeParam> kernel = OptimizeWithCeres(rounds.graph, options);
  EXPECT_NEAR(switches.objectives.back(), kernel.objectives.back(), 1e-7 * kernel.objectives.back());
  for (std::size_t n = 0; n < kernel.poses.size(); ++n)
    EXPECT_THAT(switches.poses[n], NearPose(kernel.poses[n], 1e-5));
}

TYPED_TEST(OptimizeWithCeresOf, EndsAtTheSamePosesHoweverItIsTuned) {
  const Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  GraphOptions exact;
  exact.convergence = 1e-14;
  const CeresResult<TypeParam> expected = OptimizeWithCeres(rounds.graph, exact);
  CeresTuning backwards;
  backwards.order.resize(rounds.truth.size());
  std::iota(backwards.order.rbegin(), backwards.order.rend(), 0);
  for (const CeresTuning& tuning :
       {CeresTuning{CeresLibrary::kCxSparse}, CeresTuning{CeresLibrary::kSuiteSparse, 1e4}, backwards}) {
    const CeresResult<TypeParam> result = OptimizeWithCeres(rounds.graph, exact, tuning);
    EXPECT_EQ(result.status, CeresStatus::kConverged) << result.message;
    EXPECT_NEAR(result.objective, expected.objective, 1e-8 * expected.objective);
  }
  backwards.order.pop_back();
  EXPECT_THAT(ErrorOf([&] { OptimizeWithCeres(rounds.graph, {}, backwards); }),
              testing::HasSubstr("an order of 39 nodes"));
}

TYPED_TEST(OptimizeWithCeresOf, IsReproducibleToTheLastBit) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  const CeresResult<TypeParam> once = OptimizeWithCeres(rounds.graph, {});
  const CeresResult<TypeParam> again = OptimizeWithCeres(rounds.graph, {});
  EXPECT_EQ(again.objectives, once.objectives);
  for (std::size_t n = 0; n < once.poses.size(); ++n)
    EXPECT_EQ(ToMatrix(again.poses[n]), ToMatrix(once.poses[n]));
}

TYPED_TEST(OptimizeWithCeresOf, SaysNothingOnStderrWhereItFails) {
  Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  rounds.graph.nodes[5].T_map_node.translation.x() = std::nan("");
  testing::internal::CaptureStderr();
  const CeresResult<TypeParam> result = OptimizeWithCeres(rounds.graph, {});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(result.status, CeresStatus::kFailed);
  EXPECT_NE(result.message, "");
}

TYPED_TEST(OptimizeWithCeresOf, ReachesTheIterationLimit) {
  const Rounds<TypeParam> rounds = MakeRounds<TypeParam>(kSigma);
  GraphOptions options;
  options.max_iterations = 1;
  EXPECT_EQ(OptimizeWithCeres(rounds.graph, options).status, CeresStatus::kIterationLimit);
}

/// SE-Sync's certified optimum of a public graph that is reached from the file's own guess.
TEST(OptimizeWithCeres, ReachesTheKnownOptimaOfPublicGraphs) {
  const char* const data = std::getenv("ARIADNE_DATA");
  const std::filesystem::path beside = std::filesystem::path(ARIADNE_SOURCE_DIR) / "../shared/data";
  const auto folder = (data != nullptr ? std::filesystem::path(data) : beside) / "graphs";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is missing; set ARIADNE_DATA";
  for (const auto& [name, optimum] :
       {std::pair{"parking-garage.g2o", 1.262524}, std::pair{"smallGrid3D.g2o", 1025.398060},
        std::pair{"intel.g2o", 52.348227}}) {
    std::ifstream in(folder / name);
    std::visit(
        [&](const auto& graph) {
          const auto result = OptimizeWithCeres(Isotropic(graph), {});
          EXPECT_NEAR(result.objective, optimum, 1e-6 * optimum) << name;
        },
        ReadG2o(in, name).graph);
  }
}

}  // namespace
}  // namespace ariadne::slam
