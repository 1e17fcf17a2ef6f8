#include "slam/io/g2o.h"

#include <gmock/gmock.h>

#include "slam/geometry/so3.h"
#include "slam/graph/structure.h"
#include "slam/io/file.h"
#include "tests/slam/io/support.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kIdentity3 = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 4 0 0 4 0 4";

PoseGraph2 Plane(const G2oFile& file) { return std::get<PoseGraph2>(file.graph); }
PoseGraph3 Space(const G2oFile& file) { return std::get<PoseGraph3>(file.graph); }
std::string Text(const G2oFile& file) {
  std::ostringstream out;
  std::visit([&](const auto& graph) { WriteG2o(out, graph); }, file.graph);
  return out.str();
}

TEST(G2o, ReadsAGraphInThePlaneByHand) {
  const std::string text =
      "# a square without its last side\n\n"
      "VERTEX_SE2 7 1 2 0.5\n"
      "EDGE_SE2 -3 7 1 2 4 1 2 3 4 5 6\n"
      "VERTEX_SE2 -3 0 0 0\n"
      "VERTEX_SE2 12 -1 .5 1e-1 \n"
      "  EDGE_SE2\t12 7 0 0 0 +1 0 0 1 0 1\n"
      "EDGE_PRIOR_SE2 12 9 8 0.25 1 0 0 1 0 2\n"
      "FIX 7 -3\n";
  for (const std::string& variant : {text, WithWindowsLines(text)}) {
    const G2oFile file = ReadText(variant, ReadG2o);
    const PoseGraph2 graph = Plane(file);
    ASSERT_EQ(graph.nodes.size(), 3U);
    EXPECT_EQ(graph.nodes[0].id, -3);
    EXPECT_EQ(graph.nodes[1].id, 7);
    EXPECT_EQ(graph.nodes[1].T_map_node.translation, Eigen::Vector2d(1, 2));
    EXPECT_TRUE(graph.nodes[0].fixed && graph.nodes[1].fixed && !graph.nodes[2].fixed);
    ASSERT_EQ(graph.edges.size(), 2U);
    EXPECT_EQ(graph.edges[1].from, 2U);
    EXPECT_EQ(graph.edges[1].to, 1U);
    EXPECT_NEAR(graph.edges[0].T_from_to.angle, 4.0 - 2.0 * std::numbers::pi, 1e-15);
    EXPECT_EQ(graph.edges[0].information, (Eigen::Matrix3d() << 1, 2, 3, 2, 4, 5, 3, 5, 6).finished());
    ASSERT_EQ(graph.priors.size(), 1U);
    EXPECT_EQ(graph.priors[0].node, 2U);
    EXPECT_EQ(graph.priors[0].information(2, 2), 2.0);
    EXPECT_THAT(file.node_lines, ElementsAre(5, 3, 6));
    EXPECT_THAT(file.edge_lines, ElementsAre(4, 7));
    EXPECT_THAT(file.notes, IsEmpty());
  }
}

TEST(G2o, ReadsAGraphInSpaceByHand) {
  std::string upper;
  for (int i = 1; i <= 21; ++i) upper += fmt::format(" {}", i);
  const PoseGraph3 graph =
      Space(ReadText("VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 2 3 0 0 0.7071068 0.7071068\n"
                     "EDGE_SE3:QUAT 0 1 1 2 3 0 0 0 -1" +
                         upper + "\n",
                     ReadG2o));
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_NEAR(graph.nodes[1].T_map_node.rotation.norm(), 1.0, 1e-15);
  EXPECT_EQ(graph.edges[0].T_from_to.rotation.w(), -1.0);
  // On vec(q) the file says; on the angle, twice as large, its blocks are a half and a quarter.
  const Pose3::Square& information = graph.edges[0].information;
  EXPECT_EQ(information(0, 2), 3.0);
  EXPECT_EQ(information(1, 4), 0.5 * 10.0);
  EXPECT_EQ(information(5, 1), 0.5 * 11.0);
  EXPECT_EQ(information(3, 3), 0.25 * 16.0);
  EXPECT_EQ(information(5, 4), 0.25 * 20.0);
}

/// The objective of g2o, computed from the file's own numbers, is that of the graph.
TEST(G2o, KeepsTheObjectiveInSpace) {
  RandomStream stream = NamedStream(3, "g2o");
  const Eigen::Quaterniond q = ExpSo3(DrawInBall(stream, 1.0)), q_seen = ExpSo3(DrawInBall(stream, 1.0));
  const Eigen::Vector3d t = DrawInCube(stream, 2.0), t_seen = DrawInCube(stream, 2.0);
  const Pose3::Square root = Pose3::Square::Random();
  const Pose3::Square omega = root * root.transpose();
  std::string text = fmt::format(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 {} {} {} {} {} {} {}\nEDGE_SE3:QUAT 0 1 {} {} {} "
      "{} "
      "{} {} {}",
      t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w(), t_seen.x(), t_seen.y(), t_seen.z(), q_seen.x(),
      q_seen.y(), q_seen.z(), q_seen.w());
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) text += fmt::format(" {}", omega(i, j));
  }
  const Eigen::Quaterniond difference = q_seen.conjugate() * q;
  Pose3::Tangent e;
  e << q_seen.conjugate() * (t - t_seen), (difference.w() < 0 ? -1.0 : 1.0) * difference.vec();
  const double chi2 = e.dot(omega * e);
  EXPECT_NEAR(Objective(Space(ReadText(text, ReadG2o))), chi2, 1e-12 * chi2);
}

TEST(G2o, ReadsTheRecordsOfToro) {
  const PoseGraph2 plane =
      Plane(ReadText("VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\nEDGE2 0 1 1 0 0.5 11 12 22 33 13 23\n", ReadG2o));
  EXPECT_EQ(plane.edges[0].information,
            (Eigen::Matrix3d() << 11, 12, 13, 12, 22, 23, 13, 23, 33).finished());
  const PoseGraph3 space = Space(ReadText(
      fmt::format("VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 2 3 0.1 0.2 0.3\nEDGE3 0 1 1 2 3 0.1 0.2 0.3 {}\n",
                  kIdentity3),
      ReadG2o));
  EXPECT_NEAR(Objective(space), 0.0, 1e-25);
  EXPECT_EQ(space.edges[0].information(4, 4), 4.0);  // is on the angle already
  // Roll about the sensor's own x axis, yaw about the map's z axis.
  const Eigen::Matrix3d R = space.nodes[1].T_map_node.RotationMatrix();
  EXPECT_NEAR(R(2, 0), -std::sin(0.2), 1e-15);
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), 0.3, 1e-15);
  EXPECT_NEAR(std::atan2(R(2, 1), R(2, 2)), 0.1, 1e-15);
}

TEST(G2o, PlacesVerticesThatTheFileDoesNotHave) {
  const G2oFile file =
      ReadText("EDGE_SE2 5 4 -1 0 0 1 0 0 1 0 1\nEDGE_SE2 5 6 0 2 0 1 0 0 1 0 1\n", ReadG2o);
  const PoseGraph2 graph = Plane(file);
  ASSERT_EQ(graph.nodes.size(), 3U);
  EXPECT_EQ(graph.nodes[0].id, 4);
  EXPECT_EQ(graph.nodes[2].T_map_node.translation, Eigen::Vector2d(1, 2));
  EXPECT_THAT(file.node_lines, ElementsAre(1, 1, 2));
  EXPECT_THAT(file.notes, ElementsAre("no vertex is fixed: vertex 4 is held",
                                      "no vertices in the file: placed along the edges"));
  const std::string prior = "EDGE_PRIOR_SE2 6 10 0 0 1 0 0 1 0 1\n";
  const PoseGraph2 with_prior = Plane(ReadText("EDGE_SE2 5 6 0 2 0 1 0 0 1 0 1\n" + prior, ReadG2o));
  EXPECT_EQ(with_prior.nodes[0].T_map_node.translation, Eigen::Vector2d(10, -2));
  EXPECT_NEAR(Objective(with_prior), 0.0, 1e-25);
}

TEST(G2o, MovesPriorsToTheirVertices) {
  const std::string text = fmt::format(
      "PARAMS_SE3OFFSET 4 1 2 3 0 0 0 1\nVERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
      "EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1 {0}\nEDGE_SE3_PRIOR 1 4 5 5 5 0 0 0.6 0.8 {0}\n",
      kIdentity3);
  const G2oFile file = ReadText(text, ReadG2o);
  const PosePrior<Pose3> prior = Space(file).priors.at(0);
  EXPECT_EQ(prior.node, 1U);
  const Pose3 T_node_sensor{Eigen::Quaterniond::Identity(), {1, 2, 3}};
  EXPECT_TRUE((prior.T_map_node * T_node_sensor).translation.isApprox(Eigen::Vector3d(5, 5, 5), 1e-12));
  // What g2o counts at the sensor, where the node is slightly off.
  const Pose3::Tangent tau = 1e-6 * Pose3::Tangent::LinSpaced(1.0, 2.0);
  const Pose3::Tangent e =
      PoseError(prior.T_map_node * T_node_sensor, prior.T_map_node * Pose3::Exp(tau) * T_node_sensor);
  EXPECT_NEAR(tau.dot(prior.information * tau), e.squaredNorm(), 1e-5 * e.squaredNorm());
  EXPECT_THAT(file.notes,
              ElementsAre("priors with an offset are moved to their vertices, to first order: 1"));
}

TEST(G2o, SkipsWhatSaysNothingOfPoses) {
  const G2oFile file = ReadText(
      "PARAMS_SE2OFFSET 0 0 0 0\nVERTEX_SE2 0 0 0 0\nROBOTLASER1 1 2 3\nVERTEX_SE2 1 0 0 0\nFIX 0\n"
      "EDGE_SE2 0 1 0 0 0 1 0 0 1 0 1",
      ReadG2o);
  EXPECT_THAT(file.notes, ElementsAre("records that say nothing of poses are left out: 2"));
}

TEST(G2o, WritesWhatItReadsToTheLastBit) {
  RandomStream stream = NamedStream(4, "g2o");
  PoseGraph3 graph;
  for (int i = 0; i < 50; ++i) {
    graph.nodes.push_back({3 * i - 20, DrawMotion(stream, 30.0, 3.0), i == 7});
    if (i > 0) graph.edges.push_back({i - 1U, graph.nodes.size() - 1, DrawMotion(stream, 3.0, 1.0)});
    if (i > 0) graph.edges.back().information += 0.3 * Pose3::Square::Constant(DrawUniform(stream, 0, 1));
  }
  graph.priors.push_back({9, DrawMotion(stream, 3.0, 3.0), 2.0 * Pose3::Square::Identity()});
  const std::string text = Written([](std::ostream& out, const PoseGraph3& g) { WriteG2o(out, g); }, graph);
  const G2oFile file = ReadText(text, ReadG2o);
  EXPECT_EQ(Text(file), text);
  const PoseGraph3 again = Space(file);
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    EXPECT_EQ(again.edges[i].information, graph.edges[i].information);
    EXPECT_EQ(again.edges[i].T_from_to.rotation.coeffs(), graph.edges[i].T_from_to.rotation.coeffs());
  }
  EXPECT_TRUE(again.nodes[7].fixed);
  EXPECT_EQ(again.priors.at(0).information, graph.priors[0].information);
}

TEST(G2o, RefusesToWriteWhatIsNotFinite) {
  PoseGraph2 graph;
  graph.nodes.resize(2);
  graph.edges.push_back({0, 1, Pose2()});
  graph.edges[0].information(0, 0) = std::numeric_limits<double>::infinity();
  std::ostringstream out;
  EXPECT_EQ(ErrorOf([&] { WriteG2o(out, graph); }),
            "cannot write an information matrix that is NaN or infinite");
  graph.nodes[1].T_map_node.angle = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOf([&] { WriteG2o(out, graph); }), "cannot write a pose that is NaN or infinite");
}

const std::string kTwo = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";
const std::string kEdge = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";

std::string ErrorOfGraph(const std::string& text) { return ErrorOfText(text, ReadG2o); }

TEST(G2o, RefusesDamagedLines) {
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0 1 1 nan 0 1 0 0 1 0 1\n"),
            "file:3: a number of the EDGE_SE2 is NaN or infinite");
  EXPECT_EQ(ErrorOfGraph("VERTEX_SE2 0 0 inf 0\n"),
            "file:1: a number of the VERTEX_SE2 is NaN or infinite");
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0\n"),
            "file:3: found 8 numbers after the numbers of the vertices, EDGE_SE2 has 9");
  EXPECT_THAT(ErrorOfGraph(kTwo + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1 9\n"),
              HasSubstr("file:3: found 10 numbers"));
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0\n"),
            "file:3: the number of a vertex is missing after EDGE_SE2; complete the line");
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0 1.5 1 0 0 1 0 0 1 0 1\n"),
            "file:3: '1.5' is not the number of a vertex; expected a whole number");
  EXPECT_EQ(ErrorOfGraph("VERTEX_SE2 0 0 0 zero\n"), "file:1: 'zero' is not a number");
  EXPECT_EQ(ErrorOfGraph(kTwo + "FIX\n"),
            "file:3: the number of a vertex is missing after FIX; complete the line");
  EXPECT_EQ(ErrorOfGraph("VERTEX_SE3:QUAT 0 0 0 0 0 0 0 0\n"),
            "file:1: the quaternion has length 0 instead of 1; order it qx qy qz qw");
}

TEST(G2o, RefusesUnknownRecords) {
  EXPECT_EQ(
      ErrorOfGraph(kTwo + "VERTEX_XY 2 0 0\n"),
      "file:3: 'VERTEX_XY' is a record of landmarks, which are not supported; remove them from the graph");
  EXPECT_THAT(ErrorOfGraph("EDGE_SE3_TRACKXYZ 0 1 0 0 0 0\n"), HasSubstr("record of landmarks"));
  EXPECT_THAT(ErrorOfGraph("vertex 1\n"),
              HasSubstr("file:1: 'vertex' is not a record of pose graphs; known"));
  EXPECT_EQ(
      ErrorOfGraph(kTwo + "VERTEX_SE3:QUAT 2 0 0 0 0 0 0 1\n"),
      "file:3: VERTEX_SE3:QUAT is a record of poses in space, but line 1 is of poses in the plane; a graph "
      "has one kind");
}

TEST(G2o, RefusesHopelessGraphs) {
  EXPECT_EQ(ErrorOfGraph(kTwo), "file: holds no edges between poses; there is nothing to optimize");
  EXPECT_EQ(ErrorOfGraph(""), "file: holds no edges between poses; there is nothing to optimize");
  EXPECT_EQ(ErrorOfGraph(kTwo + "VERTEX_SE2 0 5 5 0\n" + kEdge),
            "file:3: vertex 0 stands in line 1 already; remove one of the two");
  EXPECT_EQ(ErrorOfGraph(kTwo + kEdge + "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n"),
            "file:4: there is no vertex 2 in the file; add it, or remove the line");
  EXPECT_EQ(ErrorOfGraph(kTwo + kEdge + "FIX 3\n"),
            "file:4: there is no vertex 3 in the file; add it, or remove the line");
  EXPECT_EQ(ErrorOfGraph(kTwo + kEdge + "EDGE_SE2 1 1 1 0 0 1 0 0 1 0 1\n"),
            "file:4: the edge joins vertex 1 with itself; remove it");
  EXPECT_EQ(ErrorOfGraph(kTwo + kEdge + "VERTEX_SE2 8 0 0 0\nVERTEX_SE2 9 0 0 0\n" +
                         "EDGE_SE2 9 8 0 0 0 1 0 0 1 0 1\n"),
            "file:4: no edges lead from vertex 0 to vertex 8, which begins a piece of 2 of the 4 vertices; "
            "optimize the pieces as files of their own");
  EXPECT_EQ(ErrorOfGraph("EDGE_SE2 0 1 1e308 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1e308 0 0 1 0 0 1 0 1\n"),
            "file: the pose of vertex 2 is NaN or infinite; its numbers are too large to compute with");
  EXPECT_THAT(ErrorOfGraph(kEdge + "FIX 0 1\n"), HasSubstr("file: 2 vertices are fixed, but"));
  EXPECT_THAT(ErrorOfGraph(fmt::format(
                  "EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1 {0}\nEDGE_SE3_PRIOR 0 3 0 0 0 0 0 0 1 {0}", kIdentity3)),
              HasSubstr("file:2: the prior names PARAMS_SE3OFFSET 3, which is not in the file"));
}

TEST(G2o, RefusesInformationWithoutAnyPositiveEigenvalue) {
  const std::string refusal =
      "file:3: the information matrix has no positive eigenvalue, so that the edge means nothing; correct "
      "or "
      "remove it";
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0 1 1 0 0 0 0 0 0 0 0\n"), refusal);
  EXPECT_EQ(ErrorOfGraph(kTwo + "EDGE_SE2 0 1 1 0 0 -1 0 0 -1 0 -1\n"), refusal);
  const G2oFile off_diagonal = ReadText(kTwo + "EDGE_SE2 0 1 1 0 0 0 1 0 0 0 0\n", ReadG2o);
  EXPECT_THAT(IndefiniteEdges(Plane(off_diagonal)), ElementsAre(0));
}

TEST(G2o, ReadsThePublicGraphs) {
  const fs::path folder = DataFolder() / "graphs";
  ARIADNE_REQUIRE_DATA(folder);
  const G2oFile cubicle = ReadFile(folder / "cubicle.g2o", ReadG2o);
  EXPECT_EQ(Space(cubicle).nodes.size(), 5750U);
  EXPECT_EQ(Space(cubicle).edges.size(), 16869U);
  EXPECT_EQ(IndefiniteEdges(Space(cubicle)).size(), 5021U);
  const G2oFile kitti = ReadFile(folder / "kitti_00.g2o", ReadG2o);
  EXPECT_EQ(Plane(kitti).edges.size(), 4677U);
  EXPECT_EQ(kitti.notes.size(), 2U);
}

}  // namespace
}  // namespace ariadne::slam
