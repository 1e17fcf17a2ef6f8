// Matching of all scans at once, and the graph of their alignments.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/error.h"
#include "slam/graph/structure.h"
#include "slam/matching/joint_solve.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/slam/geometry/pose_samples.h"
#include "tests/slam/matching/match_tour.h"

namespace ariadne::slam {
namespace {

MatchOptions JointMethod() {
  MatchOptions match;
  match.method = MatchMethod::kJoint;
  return match;
}

/// The scans of the tour, each but the master a few centimetres and tenths of a degree off, in the frame
/// that T_other_map gives.
ScanMap BentTour(const Pose3& T_other_map = {}) {
  ScanMap map{ScanTour(), {}};
  RandomStream stream = NamedStream(1, "match_joint_test/bent");
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const Pose3 error{ExpSo3(RadFromDeg(0.5) * DrawDirection(stream)), 0.04 * DrawDirection(stream)};
    Pose3& T_map_laser = map.scans[i].T_map_laser;
    T_map_laser = T_other_map * (i == 0 ? T_map_laser : T_map_laser * error);
    map.scans[i].registered = true;
  }
  return map;
}

double RmsError(const ScanMap& map) {
  double sum = 0.0;
  const std::vector<Pose2> stops = drivers::OfficeTour();
  for (std::size_t i = 1; i < stops.size(); ++i)
    sum += std::pow(TranslationDistance(map.scans[i].T_map_laser, LaserAt(stops[i])), 2);
  return std::sqrt(sum / static_cast<double>(stops.size() - 1));
}

class JointMetric : public testing::TestWithParam<Metric> {};
INSTANTIATE_TEST_SUITE_P(Metrics, JointMetric,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(NameOf(metric.param)); });

TEST_P(JointMetric, StraightensABentTour) {
  ScanMap map = BentTour();
  AlignOptions align = TourAlignOptions();
  align.metric = GetParam();
  const double before = RmsError(map);
  const MatchResult result = FinishMatching(map, JointMethod(), align);
  ASSERT_EQ(result.passes.size(), 1u);
  EXPECT_GT(result.passes[0].links, 10u);
  EXPECT_GT(result.passes[0].moved_translation, 0.02);
  EXPECT_GT(before, 0.035);
  EXPECT_LT(RmsError(map), GetParam() == Metric::kPointToPoint ? before : 0.35 * before);
  EXPECT_THAT(map.scans[0].T_map_laser, NearPose(LaserAt(drivers::OfficeTour()[0]), 0.0))
      << "the master never moves";
}

TEST(MatchJointly, GivesTheSameMapInAnyFrame) {
  const Pose3 T_other_map{ExpSo3({0.3, -0.5, 2.0}), {40.0, -7.0, 3.0}};
  ScanMap map = BentTour(), other = BentTour(T_other_map);
  FinishMatching(map, JointMethod(), TourAlignOptions());
  FinishMatching(other, JointMethod(), TourAlignOptions());
  for (std::size_t i = 0; i < map.scans.size(); ++i)
    EXPECT_THAT(other.scans[i].T_map_laser, NearPose(T_other_map * map.scans[i].T_map_laser, 1e-5)) << i;
}

TEST(MatchJointly, GivesTheSameBytesWithTwoThreads) {
  ScanMap one = BentTour(), two = BentTour();
  AlignOptions align = TourAlignOptions();
  FinishMatching(one, JointMethod(), align);
  align.threads = 2;
  FinishMatching(two, JointMethod(), align);
  for (std::size_t i = 0; i < one.scans.size(); ++i)
    EXPECT_THAT(two.scans[i].T_map_laser, NearPose(one.scans[i].T_map_laser, 0.0)) << i;
}

TEST(MatchJointly, NeverMovesWhatIsNotRegisteredNorMovesToIt) {
  ScanMap with = BentTour(), without = BentTour();
  with.scans[5].registered = without.scans[5].registered = false;
  without.scans[5].T_map_laser.translation.x() += 100.0;
  const Pose3 before = with.scans[5].T_map_laser;
  FinishMatching(with, JointMethod(), TourAlignOptions());
  FinishMatching(without, JointMethod(), TourAlignOptions());
  EXPECT_THAT(with.scans[5].T_map_laser, NearPose(before, 0.0));
  EXPECT_THAT(with.scans[6].T_map_laser, NearPose(without.scans[6].T_map_laser, 0.0));
}

TEST(MatchJointly, LeavesScansThatOverlapNothing) {
  ScanMap map = BentTour();
  map.scans[7].T_map_laser.translation.x() += 500.0;
  const Pose3 far = map.scans[7].T_map_laser;
  FinishMatching(map, JointMethod(), TourAlignOptions());
  EXPECT_THAT(map.scans[7].T_map_laser, NearPose(far, 0.0));
}

TEST(MatchJointly, StopsAtItsBoundAndSaysSo) {
  ScanMap map = BentTour();
  MatchOptions match = JointMethod();
  match.joint.max_iterations = 1;
  const MatchResult result = FinishMatching(map, match, TourAlignOptions());
  EXPECT_FALSE(result.passes[0].settled);
  EXPECT_THAT(result.message, testing::StartsWith("all scans at once: not settled after 1 iterations"));
}

TEST(MatchJointly, PassesOverAllScansAsOftenAsIsAsked) {
  MatchOptions match = JointMethod();
  match.joint.pass_every = 2;
  Tour tour(match, TourAlignOptions());
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(tour.AddNext().passes.size(), i % 2) << i;
}

TEST(ScanGraph, IsOnePieceWithAnEdgeForEachAlignment) {
  MatchOptions match;
  match.method = MatchMethod::kGraph;
  Tour tour(match, TourAlignOptions());
  for (std::size_t i = 1; i < 5; ++i) tour.AddNext();
  const ScanGraph& graph = tour.map().graph;
  EXPECT_EQ(graph.graph.nodes.size(), 5u);
  EXPECT_NO_THROW(CheckGraph(graph.graph));
  EXPECT_THAT(IndefiniteEdges(graph.graph), testing::IsEmpty());
  EXPECT_EQ(std::ranges::count(graph.kinds, ScanEdgeKind::kOdometry), 4);
  const auto alignments = std::ranges::count(graph.kinds, ScanEdgeKind::kAlignment);
  EXPECT_GT(alignments, 4) << "more than a tree";
  EXPECT_LE(alignments, 1 + 3 * 2);
}

TEST(ScanGraph, KnowsNothingOfFreeMotions) {
  AlignResult align;
  align.assessment.emplace();
  align.assessment->observability.degenerate = 1;  // of which the first direction is a motion along x
  align.assessment->covariance = Pose3::Square::Identity();
  align.assessment->covariance(0, 0) = 4.0;
  align.assessment->covariance(1, 1) = 0.25;
  const PointCloud data{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {}, {}, {}};
  ScanGraphOptions options;
  options.systematic_position = options.systematic_angle = 0.0;
  const Pose3::Square information = InformationOf(align, data, options);
  Pose3::Tangent expected = Pose3::Tangent::Ones();
  expected[0] = 0.0;
  expected[1] = 4.0;
  EXPECT_LT((information - Pose3::Square(expected.asDiagonal())).norm(), 1e-12);
}

TEST(ScanGraph, NeedsAnAssessment) {
  EXPECT_THROW(InformationOf(AlignResult(), PointCloud(), ScanGraphOptions()), Error);
}

}  // namespace
}  // namespace ariadne::slam
