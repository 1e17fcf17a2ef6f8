// The same config gives the same bytes: again, on its resolved form, with more threads, after a kill.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::HasSubstr;

using Reruns = ProgramTest;

TEST_F(Reruns, OnTheResolvedConfigGiveTheSameBytes) {
  Must("register builtin:office --out first" + kSmall + "--set output.figures=true --set input.last=1");
  Must("register --config first/config.yaml --out by_register -q");
  Must("run first/config.yaml --out by_run -q");
  ExpectSameFiles("first", "by_register");
  ExpectSameFiles("first", "by_run");
}

TEST_F(Reruns, OfFilesGiveTheSameBytes) {
  WriteTwoScans("scans");
  Must("register scans --out first --set output.figures=false -q");
  Must("run first/config.yaml --out second -q");
  ExpectSameFiles("first", "second");
  const auto inputs = nlohmann::json::parse(Content("first/manifest.json")).at("inputs");
  EXPECT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs.at("scan000.3d").get<std::string>().size(), 64U) << "SHA-256";
}

TEST_F(Reruns, WithTwoThreadsGiveTheSameBytes) {
  for (const std::string method : {"pairwise", "metascan", "simultaneous"}) {
    const auto run = [&](const std::string& threads) {
      Must("register builtin:office --method " + method + " --set icp.threads=" + threads + " --out " +
           method + threads + kSmall);
      fs::remove(folder_ / (method + threads) / "config.yaml");  // it says how many
    };
    run("1");
    run("2");
    ExpectSameFiles(method + "1", method + "2");
  }
}

TEST_F(Reruns, WithAnotherSeedDiffer) {
  Must("register builtin:office --out a" + kSmall);
  Must("register builtin:office --set input.office.seed=2 --out b" + kSmall);
  EXPECT_NE(Content("a/trajectory.tum"), Content("b/trajectory.tum"));
  EXPECT_NE(Content("a/map.ply"), Content("b/map.ply"));
}

/// Kills runs, which must be long enough for it.
class Killed : public ProgramTest {
 protected:
  static constexpr const char* kEnough = " --set output.figures=false -q ";

  nlohmann::json Progress() const {
    return nlohmann::json::parse(Content("killed/progress.json"), nullptr, false);
  }
  /// Starts the command, and kills it as soon as so many scans are done.
  void KillAfter(int done, const std::vector<std::string>& arguments) const {
    const pid_t child = Start(arguments);
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
      const nlohmann::json progress = Progress();
      if (progress.is_object() && progress.at("done") >= done) kill(child, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(WIFSIGNALED(status)) << "it has ended before it could be killed";
  }
};

TEST_F(Killed, RunsGoOnToTheSameBytes) {
  Must(std::string("register builtin:office --out whole") + kEnough);
  KillAfter(2, {"register", "builtin:office", "--out", "killed", "--set", "output.figures=false", "-q"});
  EXPECT_EQ(Progress().at("state"), "running");
  EXPECT_EQ(Progress().at("total"), 8);
  const int done = Progress().at("done");
  EXPECT_GE(done, 2);
  EXPECT_LT(done, 8);
  KillAfter(done + 1, {"register", "--resume", "--out", "killed", "-q"});
  Must("register --resume --out killed -q");
  EXPECT_EQ(Progress().at("state"), "finished");
  ExpectSameFiles("whole", "killed");
}

TEST_F(Killed, RunsOfAConfigGoOnToo) {
  folder_.Write("my.yaml", "experiment: register\noutput:\n  figures: false\n");
  KillAfter(2, {"run", "my.yaml", "--out", "killed", "-q"});
  const Ended others = Ariadne("run my.yaml --out killed --resume --set icp.trim=0.9 -q");
  EXPECT_EQ(others.status, 1);
  EXPECT_THAT(others.err, HasSubstr("the run to resume had other options"));
  Must("run my.yaml --out killed --resume -q");
  Must("run my.yaml --out whole -q");
  ExpectSameFiles("whole", "killed");
}

}  // namespace
}  // namespace ariadne
