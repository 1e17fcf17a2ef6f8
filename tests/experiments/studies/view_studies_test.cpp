// Fig. 6 and 7, the planners against the fewest views on a floor of two rooms, and how long they take.
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
    for (const char* assignment :
         {"seeds=2", "policy_seeds=2", "study_seeds=1", "studies=policies, samplers, ways",
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

TEST_F(ViewStudyTest, AblationNbvTakesTheBoundsOfAnEarlierRun) {
  OptionEntries entries = OnTwoRooms();
  for (const char* assignment : {"studies=policies", "variants=gain"}) entries.Set(assignment);
  Run("ablation_nbv", entries);
  EXPECT_EQ(FromCsv(Content("run/policies.csv")).rows.size(), 2U) << "default and gain";
  entries.Set("bounds_of=" + (folder_ / "run").string());
  Run("ablation_nbv", entries, "again");
  EXPECT_EQ(Content("again/trials.csv"), Content("run/trials.csv"));
  EXPECT_EQ(Content("again/bounds.json"), Content("run/bounds.json"));
  entries.Set("share=0.9");
  EXPECT_THAT(ErrorOf([&] { Run("ablation_nbv", entries, "other"); }),
              testing::HasSubstr("was searched with other options"));
  entries.Set("bounds_of=" + (folder_ / "nowhere").string());
  EXPECT_THAT(ErrorOf([&] { Run("ablation_nbv", entries, "none"); }),
              testing::HasSubstr("holds no bounds"));
}

TEST_F(ViewStudyTest, AblationNbvSaysWhatItCannotDo) {
  const auto error_with = [&](const std::string& assignment) {
    OptionEntries entries = OnTwoRooms();
    entries.Set(assignment);
    return ErrorOf([&] { Run("ablation_nbv", entries, "wrong", RunDirectory::Existing::kOverwrite); });
  };
  EXPECT_THAT(error_with("studies=policies, colours"), testing::HasSubstr("there are policies, gain"));
  EXPECT_THAT(error_with("studies=c1"), testing::HasSubstr("must begin with policies"));
  EXPECT_THAT(error_with("variants=gain, magic"), testing::HasSubstr("names 'magic'"));
  EXPECT_THAT(error_with("variants=gain , area 99 m "), testing::HasSubstr("names 'area 99 m'"));
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

OptionEntries TwoScansOfTheOffice() {
  OptionEntries entries;
  for (const char* assignment : {"input.tour.waypoints=2.6 0, 4.6 0", "input.tour.scans=2"})
    entries.Set(assignment);
  return entries;
}

TEST_F(ViewStudyTest, Fig07UnitesTwoScansAndKeepsTheirLabels) {
  Run("fig_07", TwoScansOfTheOffice());
  EXPECT_THAT(Content("run/figures/fig_07.png"), testing::StartsWith("\x89PNG"));
  const Table polygons = FromCsv(Content("run/polygons.csv"));
  ASSERT_EQ(polygons.rows.size(), 3U);
  const auto area = [&](const char* name) { return NumberIn(polygons, name, "area_m2"); };
  const auto seen = [&](const char* name) { return NumberIn(polygons, name, "seen_m"); };
  const auto unseen = [&](const char* name) { return NumberIn(polygons, name, "unseen_m"); };
  EXPECT_GT(area("union"), 0.99 * std::max(area("scan 1"), area("scan 2")));
  EXPECT_LT(area("union"), area("scan 1") + area("scan 2")) << "the scans overlap";
  EXPECT_GT(seen("union"), 0.95 * std::max(seen("scan 1"), seen("scan 2")));
  EXPECT_LT(seen("union"), seen("scan 1") + seen("scan 2")) << "walls that both have seen count once";
  EXPECT_LT(unseen("union"), unseen("scan 1") + unseen("scan 2")) << "what one has seen behind is gone";
  EXPECT_GT(unseen("union"), 0.0);
  const std::string before = Content("run/polygons.csv");
  Run("fig_07", TwoScansOfTheOffice(), "again");
  EXPECT_EQ(Content("again/polygons.csv"), before);
}

TEST_F(ViewStudyTest, Fig07NeedsTwoScans) {
  OptionEntries entries = TwoScansOfTheOffice();
  entries.Set("input.tour.scans=1");
  EXPECT_THAT(ErrorOf([&] { Run("fig_07", entries); }), testing::HasSubstr("needs two scans"));
}

TEST_F(ViewStudyTest, PlanningTimeMeasuresGrowthAndHoldsItAgainstItsLimits) {
  OptionEntries entries;
  for (const char* assignment :
       {"candidates=5, 20", "edges=40, 80", "usual_candidates=10", "usual_edges=60", "decisions=3",
        "median_limit=1e6", "quantile_limit=1e-6"}) {
    entries.Set(assignment);
  }
  const StudyResult result = Run("planning_time", entries);
  EXPECT_THAT(result.text, testing::AllOf(testing::HasSubstr("within 1000000 ms"),
                                          testing::HasSubstr("MORE THAN 0 ms")));
  const Table times = FromCsv(Content("run/timing.csv"));
  ASSERT_EQ(times.rows.size(), 10U) << "of each of five pairs the whole, and candidates and gain alone";
  for (const auto& row : times.rows) EXPECT_LE(std::stod(row[4]), std::stod(row[5]));
  for (const char* plot : {"run/figures/time_by_candidates.svg", "run/figures/time_by_edges.svg"})
    EXPECT_THAT(Content(plot), testing::HasSubstr("<polyline"));
  entries.Set("edges=40, many");
  EXPECT_THAT(ErrorOf([&] { Run("planning_time", entries, "wrong"); }),
              testing::HasSubstr("edges is '40, many'"));
}

}  // namespace
}  // namespace ariadne::experiments
