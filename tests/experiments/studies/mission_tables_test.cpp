// Missions in pairs: what differs, and by how much.
#include "experiments/studies/mission_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ariadne::experiments {
namespace {

MissionTrial MissionIn(const std::string& way, int seed, double target_scans, double translation_rms) {
  MissionTrial trial;
  trial.world = "hall";
  trial.way = way;
  trial.seed = seed;
  trial.scans = 10.0;
  trial.target_scans = target_scans;
  trial.verdict.translation_rms = translation_rms;
  trial.verdict.map_error_median = 0.5 * translation_rms;
  return trial;
}

std::string CellOf(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::ranges::find(table.columns, column);
  EXPECT_NE(found, table.columns.end()) << column;
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.columns.begin()));
}

/// Both get worse by 2 mm from seed to seed; the other one is always worse by 3 mm.
TEST(MissionTables, DifferencesAreThoseOfPairs) {
  std::vector<MissionTrial> trials;
  for (int seed = 1; seed <= 4; ++seed) trials.push_back(MissionIn("default", seed, 5.0, 0.002 * seed));
  for (int seed = 1; seed <= 4; ++seed) {
    const double reached = seed == 1 ? std::numeric_limits<double>::infinity() : 5.0;
    trials.push_back(MissionIn("robot emulated", seed, reached, 0.002 * seed + 0.003));
  }
  const Table table = MissionDifferenceTable(trials, 9.0, {});
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(CellOf(table, 0, "mission"), "robot emulated - default");
  EXPECT_EQ(CellOf(table, 0, "pairs"), "4");
  EXPECT_EQ(CellOf(table, 0, "position mm"), "+3.0 [+3.0, +3.0]");
  EXPECT_EQ(CellOf(table, 0, "map mm"), "+1.5 [+1.5, +1.5]");
  EXPECT_EQ(CellOf(table, 0, "scans to target").substr(0, 4), "+1.0")
      << "9 scans once where it was not reached";
}

/// What should hold for every run is judged by the worst one, and a world by its own.
TEST(MissionTables, WorldsHaveTheirWorstRuns) {
  std::vector<MissionTrial> trials{MissionIn("default", 1, 5.0, 0.01), MissionIn("default", 2, 5.0, 0.02),
                                   MissionIn("default", 3, 5.0, 0.06), MissionIn("default", 1, 5.0, 0.3)};
  trials[0].verdict.surface_covered = 0.98;
  trials[1].verdict.surface_covered = 0.93;
  trials[2].verdict.surface_covered = 0.97;
  trials[0].ended = trials[1].ended = 1.0;
  trials[2].collisions = 3.0;
  trials[2].minutes = 12.0;
  trials[3].world = "bench";
  const Table table = MissionWorldTable(trials, 0.95);
  ASSERT_EQ(table.rows.size(), 2U);
  const std::vector<std::pair<std::string, std::string>> expected{
      {"world", "hall"},      {"runs", "3"},          {"surface %", "97.0"}, {"least surface %", "93.0"},
      {"worst cm", "6.0"},    {"position cm", "2.0"}, {"minutes", "0.0"},    {"ended %", "66.7"},
      {"collisions", "1.00"}, {"map mm", "10.0"}};
  for (const auto& [column, text] : expected) EXPECT_EQ(CellOf(table, 0, column), text) << column;
  EXPECT_EQ(CellOf(table, 1, "worst cm"), "30.0");
}

/// The robot's time is in the table over all worlds, too.
TEST(MissionTables, VariantsHaveTheirTime) {
  std::vector<MissionTrial> trials{MissionIn("default", 1, 5.0, 0.01), MissionIn("2003", 1, 5.0, 0.01)};
  trials[0].minutes = 12.5;
  trials[1].minutes = 30.0;
  const Table table = MissionVariantTable(trials, 0.95, {});
  EXPECT_EQ(CellOf(table, 0, "minutes"), "12.5");
  EXPECT_EQ(CellOf(table, 1, "minutes"), "30.0");
}

}  // namespace
}  // namespace ariadne::experiments
