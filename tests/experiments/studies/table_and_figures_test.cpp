// Table 1, Fig. 3 and Fig. 5 on small scans: what they leave, and that it is true.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/studies/small_office.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kPngSignature = "\x89PNG\r\n\x1a\n";

class Table1Test : public StudyTest {
 protected:
  void RunSmall() { result_ = Run("table_1", SmallOffice({"repeats=1", "icp.max_iterations=400"})); }
  StudyResult result_;
};

TEST_F(Table1Test, FindsTheSamePoseByBruteForceAndByKdTree) {
  RunSmall();
  const Json rows = ReadJson("run/metrics.json");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& [brute, tree] : {std::pair(0, 2), {1, 3}}) {
    const auto b = static_cast<std::size_t>(brute), t = static_cast<std::size_t>(tree);
    EXPECT_EQ(rows[b]["search"], "brute_force");
    EXPECT_EQ(rows[t]["search"], "kd_tree");
    for (const char* key :
         {"points", "data_points", "status", "iterations", "pairs", "rms_m", "T_model_data"}) {
      EXPECT_EQ(rows[b][key], rows[t][key]) << key;
    }
  }
  EXPECT_EQ(rows[0]["data_points"], 61 * 48);
  EXPECT_LT(rows[1]["data_points"], rows[0]["data_points"]);
}

TEST_F(Table1Test, LeavesTimesInAFileOfTheirOwn) {
  RunSmall();
  const Json timing = ReadJson("run/timing.json");
  ASSERT_EQ(timing.size(), 4U);
  for (const Json& row : timing) EXPECT_GT(row["seconds"].get<double>(), 0.0);
  EXPECT_THAT(Content("run/metrics.json"), testing::Not(HasSubstr("seconds")));
  EXPECT_EQ(ReadJson("run/progress.json"), (Json{{"state", "finished"}, {"done", 4}, {"total", 4}}));
  EXPECT_THAT(Content("run/config.yaml"), StartsWith("experiment: table_1\n"));
  EXPECT_THAT(result_.text, HasSubstr("brute_force"));
  EXPECT_EQ(result_.problem, "");
}

class Fig03Test : public StudyTest {};

TEST_F(Fig03Test, ComesCloserToTheFinalPose) {
  const StudyResult result =
      Run("fig_03", SmallOffice({"input.office.odometry_sigma=0.2", "reduce.method=none"}));
  const Json metrics = ReadJson("run/metrics.json");
  ASSERT_EQ(metrics["stages"].size(), 3U);
  EXPECT_EQ(metrics["stages"][0]["title"], "Odometry");
  EXPECT_EQ(metrics["stages"][1]["title"], "After 5 iterations");
  const auto x = [&](std::size_t stage) {
    const auto pose = metrics["stages"][stage]["T_model_data"].get<std::vector<double>>();
    return Eigen::Vector3d(pose[0], pose[1], pose[2]);
  };
  EXPECT_LT((x(1) - x(2)).norm(), (x(0) - x(2)).norm());
  EXPECT_GT(metrics["iterations"], 5);
  EXPECT_THAT(result.text, HasSubstr(": 0.00 cm and 0.000 deg from the final pose\n"));
}

TEST_F(Fig03Test, DrawsBothViews) {
  Run("fig_03", SmallOffice());
  EXPECT_THAT(Content("run/figures/top.png"), StartsWith(kPngSignature));
  EXPECT_THAT(Content("run/figures/oblique.png"), StartsWith(kPngSignature));
}

TEST_F(Fig03Test, SaysThatItNeedsTwoScans) {
  EXPECT_THAT(slam::testing_support::ErrorOf([&] { Run("fig_03", SmallOffice({"input.last=0"})); }),
              HasSubstr("two scans are needed, there is one"));
}

class Fig05Test : public StudyTest {};

TEST_F(Fig05Test, CountsAndDrawsThePoints) {
  const StudyResult result = Run("fig_05", SmallOffice());
  const Json metrics = ReadJson("run/metrics.json");
  const auto all = metrics["points"].get<int>(), reduced = metrics["reduced_points"].get<int>();
  EXPECT_EQ(all, 61 * 48) << "all of the walls are within range";
  EXPECT_LT(reduced, all / 2);
  EXPECT_GT(reduced, 50);
  const auto edges = metrics["edge_points"].get<int>();
  EXPECT_LT(edges, all / 2);
  EXPECT_GT(edges, 50);
  EXPECT_THAT(result.text, StartsWith(fmt::format("{} points, {} reduced points: 1 of ", all, reduced)));
  EXPECT_THAT(Content("run/figures/fig_05.png"), StartsWith(kPngSignature));
}

TEST_F(Fig05Test, DrawsTheSamePictureEveryTime) {
  Run("fig_05", SmallOffice(), "first");
  Run("fig_05", SmallOffice(), "second");
  for (const char* file : {"figures/fig_05.png", "metrics.json", "config.yaml", "manifest.json"}) {
    EXPECT_EQ(Content(std::string("first/") + file), Content(std::string("second/") + file)) << file;
  }
}

}  // namespace
}  // namespace ariadne::experiments
