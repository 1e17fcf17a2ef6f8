// Fig. 6 and 7, and the planners against the fewest views, on a floor of two rooms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/report/table.h"
#include "tests/experiments/studies/small_office.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kTwoRooms = R"({"name": "two rooms", "unit": "m", "start": [1.5, 2.5], "area": 60,
  "walls": [[0, 0, 12, 0], [12, 0, 12, 5], [12, 5, 0, 5], [0, 5, 0, 0], [6, 0, 6, 2], [6, 2.9, 6, 5]],
  "doors": [[6, 2.45]], "spaces": []})";

class ViewStudyTest : public StudyTest {
 protected:
  OptionEntries OnTwoRooms() {
    folder_.Write("two_rooms.json", kTwoRooms);
    OptionEntries entries;
    entries.Set("floors=" + (folder_ / "two_rooms.json").string());
    for (const char* assignment : {"seeds=2", "study_seeds=1", "studies=policies, samplers, ways",
                                   "floor.bound.place_spacing=1", "bootstrap.resamples=100"}) {
      entries.Set(assignment);
    }
    return entries;
  }
};

double NumberIn(const Table& table, const std::string& first, const std::string& column) {
  const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
  const auto row = std::ranges::find_if(table.rows, [&](const auto& r) { return r[0] == first; });
  return std::stod((*row)[static_cast<std::size_t>(at)]);
}

TEST_F(ViewStudyTest, AblationNbvHoldsPoliciesAgainstTheFewestViews) {
  Run("ablation_nbv", OnTwoRooms());
  const Table policies = FromCsv(Content("run/policies.csv"));
  ASSERT_EQ(policies.rows.size(), 7U);
  EXPECT_EQ(NumberIn(policies, "default", "reached %"), 100.0);
  EXPECT_EQ(NumberIn(policies, "default", "ended %"), 100.0);
  EXPECT_GT(NumberIn(policies, "default", "least %"), 99.0);
  EXPECT_GE(NumberIn(policies, "default", "scans / fewest"), 1.0);
  EXPECT_GT(NumberIn(policies, "paper", "scans / fewest"), NumberIn(policies, "default", "scans / fewest"));
  EXPECT_EQ(FromCsv(Content("run/samplers.csv")).rows.size(), 7U);
  EXPECT_EQ(FromCsv(Content("run/ways.csv")).rows.size(), 5U);
  const Table trials = FromCsv(Content("run/trials.csv"));
  EXPECT_EQ(trials.rows.size(), 7U * 2 + 12U);
  const std::string before = Content("run/trials.csv");
  OptionEntries two_threads = OnTwoRooms();
  two_threads.Set("threads=2");
  Run("ablation_nbv", two_threads, "again");
  EXPECT_EQ(Content("again/trials.csv"), before) << "whatever the number of threads";
}

TEST_F(ViewStudyTest, AblationNbvSaysWhatItCannotDo) {
  const auto error_with = [&](const std::string& assignment) {
    OptionEntries entries = OnTwoRooms();
    entries.Set(assignment);
    return ErrorOf([&] { Run("ablation_nbv", entries, "wrong", RunDirectory::Existing::kOverwrite); });
  };
  EXPECT_THAT(error_with("studies=policies, colours"), testing::HasSubstr("there are policies, gain"));
  EXPECT_THAT(error_with("studies=c1"), testing::HasSubstr("must begin with policies"));
  EXPECT_THAT(error_with("floors=a,,b"), testing::HasSubstr("names are to stand"));
  EXPECT_THAT(error_with("floors=builtin:nowhere"), testing::HasSubstr("nowhere"));
}

TEST_F(ViewStudyTest, Fig06ShowsAStepAndItsView) {
  OptionEntries entries;
  for (const char* assignment : {"input.tour.waypoints=2.6 0, 4.6 0", "input.tour.scans=1"})
    entries.Set(assignment);
  Run("fig_06", entries);
  EXPECT_THAT(Content("run/figures/fig_06.png"), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(Content("run/fig_06.svg"), testing::HasSubstr("<svg"));
  EXPECT_GT(ReadJson("run/metrics.json").size(), 3U);
}

}  // namespace
}  // namespace ariadne::experiments
