// Fig. 9 and 10: the controller's paths; controllers beside each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/report/table.h"
#include "tests/experiments/studies/small_office.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

class ControlStudyTest : public StudyTest {};

TEST_F(ControlStudyTest, Fig09ReachesThePoseFromEverywhere) {
  OptionEntries entries;
  for (const char* assignment : {"starts=8", "radius=2", "width=200"}) entries.Set(assignment);
  Run("fig_09", entries);
  const Json metrics = ReadJson("run/metrics.json");
  EXPECT_EQ(metrics["paths"], 8);
  EXPECT_EQ(metrics["reached"], 8);
  EXPECT_GT(metrics["longest_over_straight"], 2.0) << "the goal behind it";
  EXPECT_LT(metrics["longest_over_straight"], 4.0);
  const Table paths = FromCsv(Content("run/paths.csv"));
  ASSERT_EQ(paths.rows.size(), 8U);
  EXPECT_NEAR(std::stod(paths.rows[4][4]), 2.0, 0.02) << "straight ahead";
  EXPECT_THAT(Content("run/figures/fig_09.png"), testing::StartsWith("\x89PNG"));
  entries.Set("approach.law.beta=3.5");
  EXPECT_THAT(ErrorOf([&] { Run("fig_09", entries, "wrong"); }), testing::HasSubstr("law.beta is 3.5"));
}

TEST_F(ControlStudyTest, Fig10DrivesAroundBoxes) {
  OptionEntries entries;
  for (const char* assignment : {"input.tour.waypoints=2.6 0, 4.6 0", "input.tour.scans=1", "headings=2",
                                 "step.planner.refined=0", "width=300"})
    entries.Set(assignment);
  Run("fig_10", entries);
  const Json metrics = ReadJson("run/metrics.json");
  EXPECT_GT(metrics["outlines"], 5);
  EXPECT_GT(metrics["controller"], 0);
  const Table drives = FromCsv(Content("run/trajectories.csv"));
  ASSERT_GE(drives.rows.size(), 1U);
  EXPECT_EQ(drives.rows[0][0], "controller");
  EXPECT_GE(std::stod(drives.rows[0][4]), std::stod(drives.rows[0][3]) - 0.02)
      << "no shorter than the line";
  EXPECT_THAT(Content("run/figures/fig_10.png"), testing::StartsWith("\x89PNG"));
}

TEST_F(ControlStudyTest, AblationControlReachesTheGoalByEachController) {
  OptionEntries entries;
  for (const char* assignment : {"starts=20", "many=50", "distance=5"}) entries.Set(assignment);
  Run("ablation_control", entries);
  const Table controllers = FromCsv(Content("run/controllers.csv"));
  ASSERT_EQ(controllers.rows.size(), 5U);
  for (const auto& row : controllers.rows) {
    EXPECT_EQ(std::stod(row[2]), 100.0) << row[0];
    EXPECT_GE(std::stod(row[3]), 0.99) << row[0];
    EXPECT_EQ(row.back(), "0") << row[0] << " breaks no limit";
  }
  EXPECT_EQ(controllers.rows[0][0], "indiveri");
  EXPECT_EQ(controllers.rows[4][1], "50");
  EXPECT_LT(std::stod(controllers.rows[0][10]), std::stod(controllers.rows[0][9])) << "it ends straight";
  const std::string before = Content("run/trials.csv");
  EXPECT_EQ(FromCsv(before).rows.size(), 80U);
  entries.Set("threads=2");
  Run("ablation_control", entries, "again");
  EXPECT_EQ(Content("again/trials.csv"), before);
}

}  // namespace
}  // namespace ariadne::experiments
