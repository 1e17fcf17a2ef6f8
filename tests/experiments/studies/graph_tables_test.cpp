#include "experiments/studies/graph_tables.h"

#include <gmock/gmock.h>

namespace ariadne::experiments {
namespace {

using slam::Pose2;
using testing::ElementsAre;

/// Two odometry edges that are kept to exactly, and a closure that is 3 cm off.
slam::G2oFile Chain() {
  slam::PoseGraph2 graph;
  for (int i = 0; i < 3; ++i) graph.nodes.push_back({10 * i, {0.0, {1.0 * i, 0.0}}});
  graph.edges = {{0, 1, {0.0, {1.0, 0.0}}}, {1, 2, {0.0, {1.0, 0.0}}}, {0, 2, {0.0, {2.03, 0.0}}}};
  for (auto& edge : graph.edges) edge.information *= 100.0;
  return {"chain.g2o", graph, {1, 2, 3}, {4, 5, 6}, {}};
}

slam::OptimizeResult<Pose2> Kept(const slam::PoseGraph2& graph, std::vector<double> weights) {
  slam::OptimizeResult<Pose2> result;
  result.graph = graph;
  result.edge_weights = std::move(weights);
  return result;
}

TEST(GraphTables, TellEachEdgeByItsLine) {
  const slam::G2oFile file = Chain();
  const auto& graph = std::get<slam::PoseGraph2>(file.graph);
  const Table table = EdgeTable(file, graph, Kept(graph, {}));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_THAT(table.rows[0], ElementsAre("4", "0", "10", "odometry", "0", "0", "1"));
  EXPECT_EQ(table.rows[2][3], "closure");
  EXPECT_NEAR(std::stod(table.rows[2][5]), 100 * 0.03 * 0.03, 1e-12);
  EXPECT_EQ(WorstEdges(table, 1).rows.at(0)[0], "6");
  EXPECT_EQ(WorstEdges(table, 9).rows.size(), 3U);
}

TEST(GraphTables, CountNoErrorOfWhatIsRejected) {
  const slam::G2oFile file = Chain();
  const auto& graph = std::get<slam::PoseGraph2>(file.graph);
  const Table table = EdgeTable(file, graph, Kept(graph, {1.0, 1.0, 0.0}));
  EXPECT_EQ(table.rows[2][6], "0");
  EXPECT_EQ(WorstEdges(table, 1).rows.at(0)[0], "4") << "in the order of the file among equals";
  EXPECT_THAT(RejectedEdges({1.0, 0.4, 0.5, 0.0}), ElementsAre(1, 3));
}

TEST(GraphTables, NameThePhasesOfNestedTimes) {
  const Table table = TimeTable({{"read_s", 0.5}, {"isotropic_s", {{"start", 0.001}, {"total", 0.25}}}});
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre("read", "500.00"), ElementsAre("isotropic start", "1.00"),
                                      ElementsAre("isotropic total", "250.00")));
}

TEST(GraphMinima, RefuseAnObjectiveThatDoesNotExist) {
  slam::G2oFile file = Chain();
  EXPECT_NO_THROW(RequireObjective(file, GraphObjective::kInformation));
  auto& graph = std::get<slam::PoseGraph2>(file.graph);
  graph.edges[1].information(0, 1) = graph.edges[1].information(1, 0) = 120.0;
  EXPECT_THROW(RequireObjective(file, GraphObjective::kInformation), Error);
  EXPECT_THROW(RequireObjective(file, GraphObjective::kBoth), Error) << "the block is indefinite as well";
  graph.edges[1].information = 100.0 * Pose2::Square::Identity();
  graph.edges[1].information(0, 2) = graph.edges[1].information(2, 0) = 120.0;
  EXPECT_THROW(RequireObjective(file, GraphObjective::kInformation), Error);
  EXPECT_NO_THROW(RequireObjective(file, GraphObjective::kBoth)) << "the blocks alone are definite";
}

}  // namespace
}  // namespace ariadne::experiments
