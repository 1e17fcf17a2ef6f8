// Fig. 2, Fig. 11, extract and ablation_features, coarse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/studies/small_office.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class FeatureStudyTest : public StudyTest {
 protected:
  /// One scan of the corridor with the two persons.
  static OptionEntries CorridorScan(const std::vector<std::string>& assignments = {}) {
    OptionEntries entries;
    for (const char* assignment : {"input.folder=builtin:tour", "input.tour.waypoints=2.6 0, 4.6 0",
                                   "input.tour.scans=1", "input.tour.scanner.slices=128"})
      entries.Set(assignment);
    for (const std::string& assignment : assignments) entries.Set(assignment);
    return entries;
  }
};

TEST_F(FeatureStudyTest, Fig02GoesFromReflectanceToObjects) {
  Run("fig_02", CorridorScan({"width=200"}));
  const Json metrics = ReadJson("run/metrics.json");
  EXPECT_EQ(metrics["slices"], 128);
  EXPECT_GT(metrics["lines"], 500);
  EXPECT_GT(metrics["surfaces"], 5);
  EXPECT_GE(metrics["objects"], 2) << "two persons";
  EXPECT_LT(metrics["voxels"], metrics["points"]);
  for (const char* name : {"distorted", "fig_02"})
    EXPECT_THAT(Content(std::string("run/figures/") + name + ".png"), StartsWith("\x89PNG"));
}

TEST_F(FeatureStudyTest, Fig11HalvesCubesFromDepthToDepth) {
  Run("fig_11", CorridorScan({"width=200", "depths=0, 2, 6"}));
  const Table depths = FromCsv(Content("run/depths.csv"));
  ASSERT_EQ(depths.rows.size(), 3U);
  EXPECT_EQ(depths.rows[0][2], "1");
  EXPECT_DOUBLE_EQ(std::stod(depths.rows[1][1]) / std::stod(depths.rows[2][1]), 16.0);
  EXPECT_GT(std::stoi(depths.rows[2][2]), 100);
  EXPECT_THAT(ErrorOf([&] { Run("fig_11", CorridorScan({"depths=1.5"}), "wrong"); }),
              StartsWith("depths: 1.5 is no depth"));
}

TEST_F(FeatureStudyTest, ExtractTellsWhatIsInEachScan) {
  Run("extract", CorridorScan());
  const Table scans = FromCsv(Content("run/scans.csv"));
  ASSERT_EQ(scans.rows.size(), 1U);
  EXPECT_GT(std::stoi(scans.rows[0][3]), 500) << "lines";
  const Table surfaces = FromCsv(Content("run/surfaces.csv"));
  EXPECT_EQ(std::to_string(surfaces.rows.size()), scans.rows[0][5]);
  EXPECT_THAT(Content("run/surfaces.csv"), testing::AllOf(HasSubstr(",floor,"), HasSubstr(",wall,")));
  EXPECT_THAT(Content("run/drawings/" + scans.rows[0][0] + ".dxf"), HasSubstr("edge_points"));
  EXPECT_THAT(Content("run/edges/" + scans.rows[0][0] + ".ply"),
              HasSubstr("element vertex " + scans.rows[0][4] + "\n"));
}

TEST_F(FeatureStudyTest, ExtractIsTheSameEveryTime) {
  for (const char* name : {"first", "second"}) Run("extract", CorridorScan({"figures=false"}), name);
  for (const char* file : {"surfaces.csv", "objects.csv", "scans.csv"})
    EXPECT_EQ(Content(std::string("first/") + file), Content(std::string("second/") + file)) << file;
}

TEST_F(FeatureStudyTest, DetectorsAreHeldToTruth) {
  OptionEntries entries;
  for (const char* assignment : {"line_rooms=10", "surface_rooms=1", "scanner.slices=96", "logs=none"})
    entries.Set(assignment);
  const StudyResult result = Run("ablation_features", entries);
  EXPECT_THAT(result.text, HasSubstr("no logs"));
  const Table lines = FromCsv(Content("run/lines.csv"));
  ASSERT_EQ(lines.rows.size(), 4U);
  for (const auto& row : lines.rows) EXPECT_GT(std::stod(row[2]), 0.8) << row[0];
  EXPECT_EQ(FromCsv(Content("run/surfaces.csv")).rows.size(), 2U);
}

}  // namespace
}  // namespace ariadne::experiments
