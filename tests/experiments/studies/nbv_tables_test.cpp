// Medians of shares that some explorations never reach.
#include "experiments/studies/nbv_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace ariadne::experiments {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

NbvTrial Trial(const std::string& floor, const std::string& variant, std::uint64_t seed, double scans) {
  NbvTrial trial;
  trial.floor = floor;
  trial.study = "policies";
  trial.variant = variant;
  trial.seed = seed;
  trial.scans = trial.path = trial.scans_95 = trial.path_95 = scans;
  trial.covered = scans == kInf ? 0.5 : 1.0;
  trial.ended = true;
  trial.bound_scans = trial.bound_path = 10.0;
  return trial;
}

/// Of `default` on four floors 15, 16, 17, 18 scans against 10; `other` as given.
std::vector<NbvTrial> TrialsWith(const std::vector<double>& other) {
  std::vector<NbvTrial> trials;
  for (std::size_t i = 0; i < other.size(); ++i) {
    const std::string floor(1, static_cast<char>('a' + i));
    trials.push_back(Trial(floor, "default", 1, 15.0 + static_cast<double>(i)));
    trials.push_back(Trial(floor, "other", 1, other[i]));
  }
  return trials;
}

std::string Cell(const Table& table, const std::string& name, const std::string& column) {
  const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
  for (const auto& row : table.rows) {
    if (row[0] == name) return row[static_cast<std::size_t>(at)];
  }
  return "no such row";
}

BootstrapOptions Few() {
  BootstrapOptions bootstrap;
  bootstrap.resamples = 200;
  return bootstrap;
}

TEST(NbvStudyTable, AMedianThatIsNeverReachedSaysSo) {
  const Table table = NbvStudyTable(TrialsWith({kInf, kInf, kInf, 20.0}), "policies", Few());
  EXPECT_THAT(Cell(table, "other", "scans / fewest"), testing::StartsWith("never ["));
  EXPECT_THAT(Cell(table, "other", "scans, change %"), testing::StartsWith("never ["));
  EXPECT_EQ(Cell(table, "other", "reached %"), "25.0");
  EXPECT_THAT(Cell(table, "default", "scans / fewest"), testing::StartsWith("1.65 ["));
}

TEST(NbvStudyTable, HalfwayBetweenANumberAndNeverIsNever) {
  const Table table = NbvStudyTable(TrialsWith({kInf, kInf, 19.0, 20.0}), "policies", Few());
  EXPECT_THAT(Cell(table, "other", "scans / fewest"), testing::StartsWith("never ["));
}

TEST(NbvStudyTable, OneThatIsNeverReachedCountsAsTheLargest) {
  const Table table = NbvStudyTable(TrialsWith({18.0, 20.0, 22.0, 24.0, kInf}), "policies", Few());
  EXPECT_THAT(Cell(table, "other", "scans / fewest"), testing::StartsWith("2.20 ["));
  EXPECT_EQ(Cell(table, "other", "reached %"), "80.0");
}

TEST(NbvStudyTable, ARatioOfMoreThanAHundredIsANumber) {
  const Table table = NbvStudyTable(TrialsWith({1500.0, 1500.0, 1500.0}), "policies", Few());
  EXPECT_THAT(Cell(table, "other", "scans / fewest"), testing::StartsWith("150.00 ["));
}

TEST(NbvStudyTable, ComparesWithTheDefaultFromTheSameStarts) {
  std::vector<NbvTrial> trials = TrialsWith({15.0, 16.0, 17.0});
  for (const char* floor : {"a", "b", "c"}) {  // from further starts the default is much worse
    for (std::uint64_t seed = 2; seed < 6; ++seed) trials.push_back(Trial(floor, "default", seed, 90.0));
  }
  const Table table = NbvStudyTable(trials, "policies", Few());
  EXPECT_THAT(Cell(table, "other", "scans, change %"), testing::StartsWith("+0 ["));
  EXPECT_THAT(Cell(table, "default", "scans / fewest"), testing::StartsWith("9.00 ["));
}

TEST(NbvFloorTable, SaysNeverToo) {
  const std::vector<NbvTrial> trials{Trial("a", "default", 1, kInf), Trial("a", "default", 2, kInf)};
  const std::vector<NbvFloorSummary> floors{{"a", 100.0, 50.0, 11, 10}};
  EXPECT_EQ(Cell(NbvFloorTable(trials, floors), "a", "default scans"), "never");
}

}  // namespace
}  // namespace ariadne::experiments
