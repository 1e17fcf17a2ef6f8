// simulate, Fig. 4 and ablation_matching on a short tour with coarse scans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/studies/small_office.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Three stops in the corridor, 61-slice scans.
OptionEntries SmallTour(const std::string& section, const std::vector<std::string>& assignments = {}) {
  OptionEntries entries;
  for (const char* assignment : {"scans=3", "scanner.slices=61"})
    entries.Set(section + "tour." + assignment);
  for (const std::string& assignment : assignments) entries.Set(assignment);
  return entries;
}

class TourStudyTest : public StudyTest {
 protected:
  StudyResult RunAblation(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> assignments{"noise_levels=1, 3", "seeds=2", "bootstrap.resamples=100"};
    assignments.insert(assignments.end(), more.begin(), more.end());
    return Run("ablation_matching", SmallTour("input.", assignments), name);
  }
};

TEST_F(TourStudyTest, SimulatedScansAreRegisteredFromTheirFolderAsFromMemory) {
  Run("simulate", SmallTour("input."), "data");
  EXPECT_EQ(ReadJson("data/metrics.json")["scans"], 3);
  OptionEntries from_folder;
  from_folder.Set("input.folder=" + (folder_ / "data/scans").string());
  OptionEntries from_memory = SmallTour("input.");
  from_memory.Set("input.folder=builtin:tour");
  for (OptionEntries* entries : {&from_folder, &from_memory}) entries->Set("output.figures=false");
  Run("register", from_folder, "from_folder");
  Run("register", from_memory, "from_memory");
  const Json folder = ReadJson("from_folder/metrics.json"), memory = ReadJson("from_memory/metrics.json");
  EXPECT_EQ(folder["registered"], 3);
  const double error_folder = folder["errors"]["map"]["translation_rms_m"];
  const double error_memory = memory["errors"]["map"]["translation_rms_m"];
  EXPECT_NEAR(error_folder, error_memory, 1e-4) << "files hold a thousandth of a millimetre";
  EXPECT_LT(error_folder, 0.03);
}

TEST_F(TourStudyTest, Fig04ShowsEachMethod) {
  const StudyResult result = Run("fig_04", SmallTour("input."));
  EXPECT_THAT(Content("run/figures/fig_04.png"), StartsWith("\x89PNG"));
  for (const char* method :
       {"odometry", "pairwise", "metascan", "edges", "simultaneous", "graph", "joint"}) {
    EXPECT_THAT(result.text, HasSubstr(method));
  }
}

TEST_F(TourStudyTest, AblationComparesMethodsWithTheTruth) {
  RunAblation("run");
  const Table trials = FromCsv(Content("run/trials.csv"));
  ASSERT_EQ(trials.rows.size(), 2U * 2U * 8U);
  const auto map_error = [&](std::size_t row) { return std::stod(trials.rows[row][6]); };
  for (std::size_t tour = 0; tour < 4; ++tour) {
    ASSERT_EQ(trials.rows[8 * tour + 7][2], "truth");
    for (std::size_t method = 1; method < 7; ++method) {
      EXPECT_EQ(trials.rows[8 * tour + method][3], "3") << "all scans are registered";
      EXPECT_GT(map_error(8 * tour + method), 0.5 * map_error(8 * tour + 7));
    }
  }
  EXPECT_EQ(FromCsv(Content("run/paired.csv")).rows.size(), 2U * 5U * 5U);
}

TEST_F(TourStudyTest, AblationGivesTheSameBytesWithTwoThreads) {
  RunAblation("one", {"threads=1"});
  RunAblation("two", {"threads=2"});
  for (const char* file : {"trials.csv", "medians.csv", "paired.csv", "report.html"}) {
    EXPECT_EQ(Content(std::string("one/") + file), Content(std::string("two/") + file)) << file;
  }
}

TEST_F(TourStudyTest, OnlyToursCanBeJudged) {
  OptionEntries entries;
  entries.Set("input.folder=builtin:office");
  EXPECT_THAT(slam::testing_support::ErrorOf([&] { Run("ablation_matching", entries); }),
              HasSubstr("must be builtin:tour"));
}

}  // namespace
}  // namespace ariadne::experiments
