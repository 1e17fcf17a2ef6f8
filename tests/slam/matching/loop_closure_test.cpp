// Loops that have drifted beyond the gate, and closures that are wrong.
#include "slam/matching/loop_closure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/slam/matching/match_tour.h"

namespace ariadne::slam {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr double kDrift = 1.2;  // of the last scan [m]; twice the gate of the first iteration

/// A way from the first stop through the building and back: four scans, of which each but the first lies a
/// third of the drift farther off than the one before. The last one is taken at `last`.
ScanMap DriftedLoop(const Pose3& last) {
  const std::vector<Pose2> stops = drivers::OfficeTour();
  const std::vector<Pose3> truth{LaserAt(stops[0]), LaserAt(stops[4]), LaserAt(stops[5]), last};
  ScanMap map;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    map.scans.push_back(ScanAt(truth[i], i));
    map.scans[i].T_map_laser.translation.y() += kDrift * static_cast<double>(i) / 3.0;
    map.scans[i].registered = i < 3;
  }
  return map;
}

/// Beside the first stop, looking elsewhere.
Pose3 BackAtStart() {
  return LaserAt(drivers::OfficeTour()[0]) * Pose3{ExpSo3({0.0, 0.0, 0.2}), {0.3, 0.0, 0.0}};
}

/// Scans overlap only if they have more pairs than the last one has with the first where it has drifted to.
MatchOptions StrictOptions(const ScanMap& map, MatchMethod method) {
  MatchOptions match;
  match.method = method;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t pairs = CountOverlap(map.scans[i], map.scans[3], 0.25, Parallel(1));
    match.overlap_pairs = std::max(match.overlap_pairs, static_cast<int>(pairs));
  }
  return match;
}

class LoopClosureBy : public testing::TestWithParam<MatchMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, LoopClosureBy, testing::Values(MatchMethod::kGraph, MatchMethod::kJoint),
                         [](const auto& method) { return std::string(NameOf(method.param)); });

TEST_P(LoopClosureBy, ClosesALoopThatHasDriftedBeyondTheGate) {
  ScanMap map = DriftedLoop(BackAtStart());
  const Pose3 before = map.scans[2].T_map_laser;
  const MatchResult result = MatchNewScan(map, StrictOptions(map, GetParam()), TourAlignOptions());
  ASSERT_TRUE(result.registered) << result.message;
  ASSERT_FALSE(result.closures.empty());
  EXPECT_TRUE(result.closures[0].accepted) << result.closures[0].verdict;
  EXPECT_EQ(result.closures[0].from, 0u);
  EXPECT_LT(TranslationDistance(map.scans[3].T_map_laser, BackAtStart()), 0.03);
  EXPECT_LT(RotationDistance(map.scans[3].T_map_laser, BackAtStart()), RadFromDeg(0.5));
  EXPECT_GT(TranslationDistance(map.scans[2].T_map_laser, before), 0.05) << "the way back is shared out";
}

TEST_P(LoopClosureBy, LeavesTheLoopOpenIfToldTo) {
  ScanMap map = DriftedLoop(BackAtStart());
  MatchOptions match = StrictOptions(map, GetParam());
  match.graph.closure.enabled = false;
  const MatchResult result = MatchNewScan(map, match, TourAlignOptions());
  EXPECT_FALSE(result.registered);
  EXPECT_THAT(result.closures, IsEmpty());
}

TEST(LoopClosure, RefusesAScanThatOnlyMightHaveBeenThere) {
  // It was taken in the room at the other end, and is believed to be near the first stop.
  ScanMap map = DriftedLoop(LaserAt(drivers::OfficeTour()[6]));
  map.scans[3].T_map_laser = BackAtStart();
  map.scans[3].T_map_laser.translation.y() += kDrift;
  const std::vector<Pose3> before{map.scans[1].T_map_laser, map.scans[2].T_map_laser};
  const MatchResult result = MatchNewScan(map, StrictOptions(map, MatchMethod::kGraph), TourAlignOptions());
  EXPECT_FALSE(result.registered);
  ASSERT_FALSE(result.closures.empty());
  for (const Closure& closure : result.closures) {
    EXPECT_FALSE(closure.accepted) << closure.verdict;
    EXPECT_THAT(closure.verdict, StartsWith("refused: "));
  }
  EXPECT_THAT(map.scans[1].T_map_laser, NearPose(before[0], 0.0));
  EXPECT_THAT(map.scans[2].T_map_laser, NearPose(before[1], 0.0));
}

TEST(LoopClosure, RefusesWhatContradictsTheGraph) {
  ScanMap map = DriftedLoop(BackAtStart());
  const MatchOptions match = StrictOptions(map, MatchMethod::kGraph);
  AddMissingNodes(map, match.graph);
  const std::vector<ClosureCandidate> candidates =
      ProposeClosures(map, match, TourAlignOptions(), Parallel(1));
  ASSERT_FALSE(candidates.empty());
  ASSERT_EQ(candidates[0].scan, 0u);
  EXPECT_TRUE(TryClosure(map, candidates[0], match, TourAlignOptions(), Parallel(1)).accepted);
  ClosureCandidate certain = candidates[0];
  certain.covariance *= 1e-4;  // the graph believes to know where the scan is
  const Closure closure = TryClosure(map, certain, match, TourAlignOptions(), Parallel(1));
  EXPECT_FALSE(closure.accepted);
  EXPECT_THAT(closure.verdict, StartsWith("refused: a squared distance of "));
}

TEST(LoopClosure, ProposesNothingWhereTheGraphIsCertain) {
  MatchOptions match;
  match.method = MatchMethod::kGraph;
  Tour tour(match, TourAlignOptions());
  for (std::size_t i = 1; i < 5; ++i) EXPECT_THAT(tour.AddNext().closures, IsEmpty());
}

/// The largest error of a scan after a wrong closure has come in: scans 0 and 4, a metre off.
double ErrorWithWrongClosure(GraphRobust robust) {
  MatchOptions match;
  match.method = MatchMethod::kGraph;
  match.graph.robust = robust;
  Tour tour(match, TourAlignOptions());
  for (std::size_t i = 1; i < 6; ++i) tour.AddNext();
  ScanGraph& graph = tour.map().graph;
  PoseEdge<Pose3> wrong = graph.graph.edges.back();
  wrong.from = 0;
  wrong.to = 4;
  wrong.T_from_to = tour.Truth(0).Inverse() * tour.Truth(4) * Pose3{ExpSo3({0, 0, 0.2}), {1.0, 0.5, 0.0}};
  graph.graph.edges.push_back(wrong);
  graph.kinds.push_back(ScanEdgeKind::kClosure);
  EXPECT_THAT(tour.AddNext().passes, SizeIs(1));
  double largest = 0.0;
  for (std::size_t i = 0; i < 7; ++i) {
    largest = std::max(largest, TranslationDistance(tour.scans()[i].T_map_laser, tour.Truth(i)));
  }
  return largest;
}

TEST(LoopClosure, AWrongOneDoesNotBendTheMap) {
  EXPECT_LT(ErrorWithWrongClosure(GraphRobust::kDcs), 0.03);
  EXPECT_LT(ErrorWithWrongClosure(GraphRobust::kGnc), 0.03);
  EXPECT_GT(ErrorWithWrongClosure(GraphRobust::kNone), 0.1) << "without a kernel it does";
}

}  // namespace
}  // namespace ariadne::slam
