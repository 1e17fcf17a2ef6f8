#include "slam/graph/structure.h"

#include <gmock/gmock.h>

#include <limits>

#include "slam/base/random.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Pose2 DrawPose(RandomStream& stream, const Pose2*) {
  return Pose2::Exp(
      Eigen::Vector3d(DrawUniform(stream, -3, 3), DrawUniform(stream, -3, 3), DrawUniform(stream, -3, 3)));
}
Pose3 DrawPose(RandomStream& stream, const Pose3*) { return DrawMotion(stream, 3.0, 3.0); }

double Distance(const Pose2& a, const Pose2& b) { return (a.Inverse() * b).Log().norm(); }
double Distance(const Pose3& a, const Pose3& b) { return (a.Inverse() * b).Log().norm(); }

/// Random poses with exact edges between the given nodes, some of them against the order of the poses.
template <typename Pose>
PoseGraph<Pose> ExactGraph(std::size_t nodes,
                           const std::vector<std::pair<std::size_t, std::size_t>>& edges) {
  RandomStream stream = NamedStream(7, "structure");
  PoseGraph<Pose> graph;
  for (std::size_t i = 0; i < nodes; ++i) {
    graph.nodes.push_back(
        {static_cast<std::int64_t>(10 * i), DrawPose(stream, static_cast<Pose*>(nullptr))});
  }
  for (const auto& [from, to] : edges) {
    graph.edges.push_back({from, to, graph.nodes[from].T_map_node.Inverse() * graph.nodes[to].T_map_node});
  }
  return graph;
}

template <typename Pose>
class Structure : public testing::Test {};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(Structure, Poses);

TYPED_TEST(Structure, NumbersPiecesByTheirFirstNodes) {
  const auto graph = ExactGraph<TypeParam>(7, {{5, 1}, {1, 3}, {2, 6}, {6, 4}});
  EXPECT_THAT(FindPieces(graph), ElementsAre(0, 1, 2, 1, 2, 1, 2));
  EXPECT_THAT(FindPieces(PoseGraph<TypeParam>()), ElementsAre());
}

TYPED_TEST(Structure, AcceptsOnePieceOnly) {
  auto graph = ExactGraph<TypeParam>(4, {{0, 1}, {2, 3}});
  EXPECT_EQ(
      ErrorOf([&] { CheckGraph(graph); }),
      "the graph is not one piece: no edges lead from vertex 0 to vertex 20; optimize its 2 pieces alone");
  graph.edges.push_back({3, 0, TypeParam()});
  EXPECT_NO_THROW(CheckGraph(graph));
  EXPECT_THAT(ErrorOf([] { CheckGraph(PoseGraph<TypeParam>()); }), HasSubstr("has no vertices"));
}

TYPED_TEST(Structure, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto graph = ExactGraph<TypeParam>(3, {{0, 1}, {1, 2}});
  const auto error_with = [&](const auto& damage) {
    auto damaged = graph;
    damage(damaged);
    return ErrorOf([&] { CheckGraph(damaged); });
  };
  EXPECT_EQ(error_with([&](auto& g) { g.nodes[1].T_map_node.translation.x() = nan; }),
            "the pose of vertex 10 is NaN or infinite");
  EXPECT_EQ(error_with([&](auto& g) { g.edges[1].information(0, 1) = nan; }),
            "the edge from vertex 10 to 20 holds NaN or infinity");
  EXPECT_EQ(error_with([&](auto& g) { g.edges[0].T_from_to.translation.y() = 1.0 / 0.0; }),
            "the edge from vertex 0 to 10 holds NaN or infinity");
  EXPECT_EQ(error_with([&](auto& g) {
              g.priors.push_back({2, TypeParam()}), g.priors[0].information *= nan;
            }),
            "the prior of vertex 20 holds NaN or infinity");
  EXPECT_THAT(error_with([&](auto& g) { g.edges[1].to = 3; }), HasSubstr("joins nodes 1 and 3 of 3"));
  EXPECT_THAT(error_with([&](auto& g) { g.edges[1].to = 1; }), HasSubstr("joins nodes 1 and 1 of 3"));
  EXPECT_THAT(error_with([&](auto& g) {
                g.priors.push_back({3, TypeParam()});
              }),
              HasSubstr("of node 3 of 3"));
}

TYPED_TEST(Structure, FindsIndefiniteEdges) {
  auto graph = ExactGraph<TypeParam>(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  graph.edges[1].information(0, 1) = graph.edges[1].information(1, 0) = 1.5;  // eigenvalue -0.5
  graph.edges[2].information(0, 1) = graph.edges[2].information(1, 0) = 0.9;
  graph.edges[3].information(1, 1) = 0.0;
  EXPECT_THAT(IndefiniteEdges(graph), ElementsAre(1, 3));
}

TYPED_TEST(Structure, PlacesAlongExactEdges) {
  const auto exact =
      ExactGraph<TypeParam>(8, {{0, 1}, {2, 1}, {2, 3}, {3, 7}, {7, 6}, {5, 6}, {1, 4}, {0, 3}});
  for (const std::size_t fixed : {0U, 4U, 6U}) {
    auto graph = exact;
    for (auto& node : graph.nodes) node.T_map_node = TypeParam();
    graph.nodes[fixed] = exact.nodes[fixed];
    graph.nodes[fixed].fixed = true;
    PlaceAlongEdges(graph);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      EXPECT_LT(Distance(graph.nodes[i].T_map_node, exact.nodes[i].T_map_node), 1e-12) << i;
    }
  }
}

TYPED_TEST(Structure, TrustsOdometryBeforeClosures) {
  // The closures would take all nodes to places far off.
  auto graph = ExactGraph<TypeParam>(6, {{0, 2}, {0, 4}, {0, 1}, {1, 2}, {2, 3}, {3, 4}, {5, 4}, {0, 5}});
  const auto exact = graph;
  for (auto& edge : graph.edges) {
    if (IsClosure(edge)) edge.T_from_to.translation.x() += 100.0;
  }
  for (std::size_t i = 1; i < graph.nodes.size(); ++i) graph.nodes[i].T_map_node = TypeParam();
  PlaceAlongEdges(graph);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    EXPECT_LT(Distance(graph.nodes[i].T_map_node, exact.nodes[i].T_map_node), 1e-12) << i;
  }
}

TYPED_TEST(Structure, LeavesAllFixedNodes) {
  auto graph = ExactGraph<TypeParam>(4, {{0, 1}, {1, 2}, {2, 3}});
  graph.nodes[0].fixed = graph.nodes[3].fixed = true;
  graph.nodes[3].T_map_node.translation.x() += 1.0;
  const TypeParam kept = graph.nodes[3].T_map_node;
  PlaceAlongEdges(graph);
  EXPECT_EQ(graph.nodes[3].T_map_node.translation, kept.translation);
}

}  // namespace
}  // namespace ariadne::slam
