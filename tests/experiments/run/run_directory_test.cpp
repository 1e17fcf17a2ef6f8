#include "experiments/run/run_directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using Existing = RunDirectory::Existing;
using slam::testing_support::ContentOf;
using slam::testing_support::ErrorOf;
using slam::testing_support::TemporaryFolder;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
namespace fs = std::filesystem;

class RunDirectoryTest : public testing::Test {
 protected:
  std::string ErrorOfOpening(const fs::path& path, Existing existing) const {
    return ErrorOf([&] { RunDirectory(path, existing); });
  }
  Json Progress() const { return Json::parse(ContentOf(path_ / "progress.json")); }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "results/first";
};

TEST_F(RunDirectoryTest, MakesAllFoldersOnTheWay) {
  const RunDirectory run(path_, Existing::kRefuse);
  EXPECT_EQ(run.path(), path_);
  EXPECT_TRUE(fs::is_directory(path_));
  run.WriteText("figures/a/b.txt", "text");
  EXPECT_EQ(ContentOf(path_ / "figures/a/b.txt"), "text");
  EXPECT_EQ(run.ReadText("figures/a/b.txt"), "text");
}

TEST_F(RunDirectoryTest, HoldsARunFromTheFirstMoment) {
  EXPECT_FALSE(HoldsRun(path_));
  const RunDirectory run(path_, Existing::kRefuse);
  EXPECT_TRUE(HoldsRun(path_));
  EXPECT_EQ(Progress(), (Json{{"state", "running"}, {"done", 0}, {"total", 0}}));
}

TEST_F(RunDirectoryTest, RefusesToTouchARunUnlessAskedTo) {
  RunDirectory(path_, Existing::kRefuse).WriteText("metrics.json", "1");
  EXPECT_THAT(ErrorOfOpening(path_, Existing::kRefuse),
              AllOf(HasSubstr("holds a run already"), HasSubstr("--overwrite or --resume")));
  EXPECT_EQ(ContentOf(path_ / "metrics.json"), "1");
}

TEST_F(RunDirectoryTest, RemovesWhatAnOverwrittenRunHasLeft) {
  RunDirectory(path_, Existing::kRefuse).WriteText("figures/old.png", "1");
  const RunDirectory run(path_, Existing::kOverwrite);
  EXPECT_FALSE(fs::exists(path_ / "figures"));
  EXPECT_TRUE(HoldsRun(path_));
}

TEST_F(RunDirectoryTest, KeepsWhatAResumedRunHasLeft) {
  const RunDirectory killed(path_, Existing::kRefuse);
  killed.WriteText("checkpoint.json", "1");
  killed.WriteProgress("running", 3, 8);
  const RunDirectory resumed(path_, Existing::kResume);
  EXPECT_EQ(resumed.ReadText("checkpoint.json"), "1");
  EXPECT_EQ(Progress()["done"], 3);
}

TEST_F(RunDirectoryTest, RemovesTheHalfFilesOfAKilledRun) {
  const RunDirectory killed(path_, Existing::kRefuse);
  killed.WriteText("map.ply.4711-0.partial", "half");
  killed.WriteText("figures/top.png.4711-0.partial", "half");
  killed.WriteText("figures/done.png", "whole");
  const RunDirectory resumed(path_, Existing::kResume);
  EXPECT_FALSE(fs::exists(path_ / "map.ply.4711-0.partial"));
  EXPECT_FALSE(fs::exists(path_ / "figures/top.png.4711-0.partial"));
  EXPECT_TRUE(fs::exists(path_ / "figures/done.png"));
}

TEST_F(RunDirectoryTest, NeverUsesAFolderWithSomethingElseInIt) {
  folder_.Write("thesis/chapter.tex", "years of work");
  for (const Existing existing : {Existing::kRefuse, Existing::kOverwrite, Existing::kResume}) {
    EXPECT_NE(ErrorOfOpening(folder_ / "thesis", existing), "");
  }
  EXPECT_THAT(ErrorOfOpening(folder_ / "thesis", Existing::kOverwrite),
              HasSubstr("is not a run directory"));
  EXPECT_EQ(ContentOf(folder_ / "thesis/chapter.tex"), "years of work");
}

TEST_F(RunDirectoryTest, TakesAnEmptyFolder) {
  fs::create_directories(path_);
  EXPECT_NO_THROW(RunDirectory(path_, Existing::kRefuse));
}

TEST_F(RunDirectoryTest, HasNothingToResumeWhereThereIsNoRun) {
  EXPECT_THAT(ErrorOfOpening(path_, Existing::kResume), HasSubstr("there is no run to resume"));
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(RunDirectoryTest, SaysWhyItCannotBeMade) {
  folder_.Write("file", "");
  EXPECT_THAT(ErrorOfOpening(folder_ / "file/run", Existing::kRefuse), EndsWith("Not a directory"));
  EXPECT_THAT(ErrorOfOpening(folder_ / "file", Existing::kOverwrite), HasSubstr("is not a run directory"));
}

TEST_F(RunDirectoryTest, TellsThatAndWhyARunHasFailed) {
  const RunDirectory run(path_, Existing::kRefuse);
  run.WriteProgress("running", 3, 8);
  const auto fail = [] { throw std::runtime_error("scan003.3d:7: \"NaN\""); };
  EXPECT_THROW(NotingFailure(run, fail), std::runtime_error);
  EXPECT_EQ(Progress(),
            (Json{{"state", "failed"}, {"done", 3}, {"total", 8}, {"error", "scan003.3d:7: \"NaN\""}}));
}

TEST_F(RunDirectoryTest, PassesOnWhatTheWorkReturns) {
  const RunDirectory run(path_, Existing::kRefuse);
  EXPECT_EQ(NotingFailure(run, [] { return 7; }), 7);
  EXPECT_EQ(Progress()["state"], "running");
}

TEST_F(RunDirectoryTest, PassesOnTheFailureEvenWhereItCannotBeNoted) {
  const RunDirectory run(path_, Existing::kRefuse);
  const auto fail = [&] {
    fs::remove_all(path_);
    Fail("the disk is gone");
  };
  EXPECT_EQ(ErrorOf([&] { NotingFailure(run, fail); }), "the disk is gone");
}

TEST_F(RunDirectoryTest, ResumesOnlyWithTheSameOptions) {
  RunDirectory(path_, Existing::kRefuse).WriteConfig("a: 1\n");
  EXPECT_NO_THROW(RunDirectory(path_, Existing::kResume).WriteConfig("a: 1\n"));
  EXPECT_THAT(ErrorOf([&] { RunDirectory(path_, Existing::kResume).WriteConfig("a: 2\n"); }),
              HasSubstr("the run to resume had other options"));
  EXPECT_EQ(ContentOf(path_ / "config.yaml"), "a: 1\n");
  EXPECT_NO_THROW(RunDirectory(path_, Existing::kOverwrite).WriteConfig("a: 2\n"));
}

TEST_F(RunDirectoryTest, WritesTablesAndKeepsTheOrderOfKeys) {
  const RunDirectory run(path_, Existing::kRefuse);
  run.WriteCsv("a.csv", {{"x", "y"}, {{"1", "2"}}});
  run.WriteJson("a.json", {{"z", 1.5}, {"a", nullptr}});
  EXPECT_EQ(ContentOf(path_ / "a.csv"), "x,y\n1,2\n");
  EXPECT_EQ(ContentOf(path_ / "a.json"), "{\n  \"z\": 1.5,\n  \"a\": null\n}\n");
}

}  // namespace
}  // namespace ariadne::experiments
