// Matching of many scans by each of the three methods (Sec. 3.2), on the tour of the simulated office.
#include "slam/matching/match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/slam/matching/match_tour.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class MatchBy : public testing::TestWithParam<MatchMethod> {
 protected:
  MatchBy() { match_.method = GetParam(); }
  MatchOptions match_;
  const AlignOptions align_ = TourAlignOptions();
};
INSTANTIATE_TEST_SUITE_P(Methods, MatchBy,
                         testing::Values(MatchMethod::kPairwise, MatchMethod::kMetascan,
                                         MatchMethod::kSimultaneous, MatchMethod::kGraph,
                                         MatchMethod::kJoint),
                         [](const auto& method) { return std::string(NameOf(method.param)); });

TEST_P(MatchBy, BringsTheScansOfTheTourToTheirPlaces) {
  Tour tour(match_, align_);
  for (std::size_t i = 1; i < tour.size(); ++i) {
    const MatchResult result = tour.AddNext();
    EXPECT_TRUE(result.registered) << result.message;
    EXPECT_TRUE(tour.scans().back().registered);
    EXPECT_GT(tour.ErrorOfGuess(), 0.12) << "15 cm off, and 4 degrees";
  }
  for (std::size_t i = 0; i < tour.size(); ++i) {
    EXPECT_LT(TranslationDistance(tour.scans()[i].T_map_laser, tour.Truth(i)), 0.02) << i;
    EXPECT_LT(RotationDistance(tour.scans()[i].T_map_laser, tour.Truth(i)), RadFromDeg(0.5)) << i;
  }
  EXPECT_THAT(tour.scans()[0].T_map_laser, NearPose(tour.Truth(0), 0.0)) << "the master never moves";
}

TEST_P(MatchBy, LogsTheAlignmentOfTheNewScanFirst) {
  Tour tour(match_, align_);
  tour.AddNext();
  const MatchResult result = tour.AddNext();
  const MatchStep& first = result.steps.at(0);
  EXPECT_EQ(first.scan, 2u);
  EXPECT_THAT(result.T_map_laser_guess, NearPose(tour.guess(), 0.0));
  EXPECT_DOUBLE_EQ(first.moved_translation, TranslationDistance(tour.guess(), first.align.T_model_data));
  EXPECT_DOUBLE_EQ(first.moved_rotation, RotationDistance(tour.guess(), first.align.T_model_data));
  if (GetParam() == MatchMethod::kMetascan) {
    EXPECT_THAT(first.partners, ElementsAre(0, 1));
  }
}

TEST_P(MatchBy, LeavesAScanThatOverlapsNothingAndNeverMatchesToIt) {
  Tour tour(match_, align_);
  tour.AddNext();
  const Pose3 far{Eigen::Quaterniond::Identity(), {300.0, 0.0, 0.0}};
  for (int i = 0; i < 2; ++i) {  // the second one sees just what the first sees
    const MatchResult result = tour.AddAt(far);
    EXPECT_FALSE(result.registered);
    EXPECT_FALSE(tour.scans().back().registered);
    EXPECT_THAT(tour.scans().back().T_map_laser, NearPose(far, 0.0)) << "it stays at its guess";
    EXPECT_THAT(result.message, testing::HasSubstr("0 pairs within "));
  }
  const MatchResult next = tour.AddNext();
  EXPECT_TRUE(next.registered);
  for (const MatchStep& step : next.steps) {
    EXPECT_THAT(step.partners, testing::Each(testing::Not(testing::AnyOf(2u, 3u))));
  }
}

TEST_P(MatchBy, DoesNotTakeAPoseFromAFailedAlignment) {
  AlignOptions align = align_;
  align.max_iterations = 2;
  Tour tour(match_, align);
  const MatchResult result = tour.AddNext();
  EXPECT_FALSE(result.registered);
  EXPECT_EQ(result.message, "not converged after 2 iterations");
  EXPECT_GT(result.steps.at(0).moved_translation, 0.01) << "it did move in the attempt";
  EXPECT_THAT(tour.scans().back().T_map_laser, NearPose(tour.guess(), 0.0));
}

TEST_P(MatchBy, HasNothingToMatchToBeforeTheFirstScanIsRegistered) {
  ScanMap map;
  map.scans.push_back(ScanAt(Pose3(), 0));
  EXPECT_EQ(MatchNewScan(map, match_, align_).message, "no scan is registered yet");
  map.scans.push_back(ScanAt(Pose3(), 1));
  EXPECT_EQ(MatchNewScan(map, match_, align_).message, "no scan is registered yet");
  EXPECT_THAT(MatchNewScan(map, match_, align_).steps, IsEmpty());
}

TEST_P(MatchBy, LeavesAScanWithoutPoints) {
  Tour tour(match_, align_);
  const MatchResult result = tour.Add({"empty", {}, KdTree({}), Pose3()});
  EXPECT_FALSE(result.registered);
  EXPECT_EQ(result.message, "the scan has no points");
}

TEST_P(MatchBy, TellsItsProgress) {
  std::vector<MatchProgress> progress;
  Tour tour(match_, align_, [&](const MatchProgress& now) { progress.push_back(now); });
  const MatchResult result = tour.AddNext();
  std::size_t iterations = 0;
  for (const MatchStep& step : result.steps) iterations += step.align.iterations.size();
  EXPECT_GE(progress.size(), iterations);
  for (const MatchProgress& now : progress) EXPECT_EQ(now.scan, 1u);
}

TEST(MatchPairwise, TakesThePartnerWithTheLargestOverlap) {
  MatchOptions match;
  match.method = MatchMethod::kPairwise;
  Tour tour(match, TourAlignOptions());
  int not_the_last = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) {
    const MapScan next = tour.Next();
    std::size_t best = 0, most = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const std::size_t pairs = CountOverlap(tour.scans()[k], next, 0.25, Parallel(1));
      if (pairs > most) best = k;
      most = std::max(most, pairs);
    }
    const MatchResult result = tour.AddNext();
    ASSERT_EQ(result.steps.size(), 1u);
    EXPECT_THAT(result.steps[0].partners, ElementsAre(best));
    not_the_last += best + 1 != i;
  }
  EXPECT_GT(not_the_last, 0) << "else the last scan would always do";
}

TEST(MatchPairwise, WantsMoreThanTheGivenOverlap) {
  MatchOptions match;
  match.method = MatchMethod::kPairwise;
  Tour tour(match, TourAlignOptions());
  const auto overlap = static_cast<int>(CountOverlap(tour.scans()[0], tour.Next(), 0.25, Parallel(1)));
  const auto add_with = [&](int overlap_pairs) {
    match.overlap_pairs = overlap_pairs;
    return Tour(match, TourAlignOptions()).AddNext();
  };
  EXPECT_TRUE(add_with(overlap - 1).registered);
  EXPECT_FALSE(add_with(overlap).registered);
  EXPECT_EQ(
      add_with(overlap).message,
      fmt::format("no earlier scan overlaps: at best {0} pairs within 0.25 m, more than {0} are needed",
                  overlap));
}

}  // namespace
}  // namespace ariadne::slam
