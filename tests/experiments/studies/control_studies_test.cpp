// Fig. 9: the controller's paths.
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

}  // namespace
}  // namespace ariadne::experiments
