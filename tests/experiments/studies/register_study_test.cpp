#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "slam/io/cloud_io.h"
#include "tests/experiments/studies/small_office.h"

namespace ariadne::experiments {
namespace {

using slam::testing_support::ErrorOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

class RegisterStudyTest : public StudyTest {
 protected:
  static OptionEntries Small(std::vector<std::string> assignments = {}) {
    assignments.insert(assignments.begin(), {"output.figures=false", "input.last=2"});
    return SmallOffice(assignments);
  }
  /// The scans of the office as files, with their odometry, at in/.
  OptionEntries AsFiles() {
    OfficeScanOptions office;
    office.beams = 61;
    office.slices = 48;
    std::string poses;
    for (std::size_t i = 0; i < 3; ++i) {
      const slam::Pose3 pose = OdometryPoses(office)[i];
      const Eigen::Vector3d& t = pose.translation;
      const Eigen::Quaterniond& q = pose.rotation;
      poses += fmt::format("{} {} {} {} {} {} {} {}\n", i, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
      fs::create_directories(folder_ / "in");
      slam::WriteCloud(folder_ / fmt::format("in/scan{}.xyz", i), ScanOffice(office, i));
    }
    folder_.Write("in/poses.txt", poses);
    OptionEntries entries;
    entries.Set("input.folder=" + (folder_ / "in").string());
    entries.Set("output.figures=false");
    return entries;
  }
};

TEST_F(RegisterStudyTest, BringsTheMapNearerToTheTruth) {
  const StudyResult result = Run("register", Small());
  const Json metrics = ReadJson("run/metrics.json");
  EXPECT_EQ(metrics["scans"], 3);
  EXPECT_EQ(metrics["registered"], 3);
  const Json& errors = metrics["errors"];
  EXPECT_GT(errors["odometry"]["translation_rms_m"], 0.05);
  EXPECT_LT(errors["map"]["translation_rms_m"], 0.03);
  EXPECT_LT(metrics["median_plane_distance_after_m"], metrics["median_plane_distance_before_m"]);
  EXPECT_THAT(result.text, HasSubstr("error against the truth, rms: odometry"));
  EXPECT_EQ(result.problem, "");
}

TEST_F(RegisterStudyTest, LeavesWhatItsReadmeSays) {
  Run("register", SmallOffice());
  for (const char* file :
       {"README.txt", "config.yaml", "manifest.json", "progress.json", "metrics.json", "scans.csv",
        "steps.csv", "iterations.csv", "covariances.csv", "residuals.csv", "trajectory.tum", "poses.txt",
        "scans/scan001.frames", "map.ply", "figures/top_before.png", "figures/top_after.png",
        "figures/oblique.png", "timing.json"}) {
    EXPECT_GT(Content(std::string("run/") + file).size(), 0U) << file;
  }
  EXPECT_FALSE(fs::exists(folder_ / "run/checkpoint.json"));
  EXPECT_EQ(ReadJson("run/progress.json"), (Json{{"state", "finished"}, {"done", 2}, {"total", 2}}));
}

TEST_F(RegisterStudyTest, LeavesOutWhatIsNotWanted) {
  Run("register", Small({"output.map=false"}));
  EXPECT_FALSE(fs::exists(folder_ / "run/map.ply"));
  EXPECT_FALSE(fs::exists(folder_ / "run/figures"));
}

TEST_F(RegisterStudyTest, SaysWhichScansItCouldNotRegister) {
  const StudyResult result = Run("register", Small({"registration.overlap_pairs=100000"}));
  EXPECT_EQ(result.problem, "2 of 3 scans could not be registered; scans.csv says why");
  EXPECT_EQ(ReadJson("run/metrics.json")["registered"], 1);
  EXPECT_THAT(Content("run/scans.csv"), HasSubstr("no earlier scan overlaps"));
}

TEST_F(RegisterStudyTest, GoesOnAfterADamagedScanIsMended) {
  const OptionEntries entries = AsFiles();
  Run("register", entries, "whole");
  const std::string good = Content("in/scan2.xyz");
  folder_.Write("in/scan2.xyz", good + "1 2\n");
  EXPECT_THAT(ErrorOf([&] { Run("register", entries); }), HasSubstr("scan2.xyz:2929: "));
  EXPECT_EQ(ReadJson("run/progress.json")["done"], 2);
  EXPECT_TRUE(fs::exists(folder_ / "run/checkpoint.json"));
  folder_.Write("in/scan2.xyz", good);
  Run("register", entries, "run", RunDirectory::Existing::kResume);
  EXPECT_FALSE(fs::exists(folder_ / "run/checkpoint.json"));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "whole")) {
    const std::string file = entry.path().filename().string();
    if (!entry.is_regular_file() || file == "timing.json") continue;
    EXPECT_EQ(Content("run/" + file), Content("whole/" + file)) << file;
  }
}

TEST_F(RegisterStudyTest, DoesNotMixTwoRuns) {
  const OptionEntries entries = AsFiles();
  const std::string scan0 = Content("in/scan0.xyz"), scan2 = Content("in/scan2.xyz");
  folder_.Write("in/scan2.xyz", "");
  ErrorOf([&] { Run("register", entries); });
  folder_.Write("in/scan2.xyz", scan2);
  OptionEntries others = entries;
  others.Set("icp.trim=0.9");
  const auto resume = [&](const OptionEntries& with) {
    return ErrorOf([&] { Run("register", with, "run", RunDirectory::Existing::kResume); });
  };
  EXPECT_THAT(resume(others), HasSubstr("the run to resume had other options"));
  folder_.Write("in/scan0.xyz", scan0 + "1 2 3\n");
  EXPECT_THAT(resume(entries), HasSubstr("scan0.xyz: has changed since"));
}

}  // namespace
}  // namespace ariadne::experiments
