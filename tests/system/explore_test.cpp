// A mission that is killed at any moment goes on to the same map; a full disk ends it and says so.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "slam/base/random.h"
#include "tests/system/program.h"
#include "tests/system/rooms.h"

namespace ariadne {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Explore : public ProgramTest {
 protected:
  void SetUp() override {
    folder_.Write("rooms.json", kTwoRoomsPlan);
    folder_.Write("rooms.yaml", RoomsConfig(5, "robot:\n  ais:\n    slices: 64\n"));
  }

  /// Starts the command, and kills it after a time, if it has not ended before.
  bool KillAfter(std::chrono::milliseconds time, const std::vector<std::string>& arguments) const {
    const pid_t child = Start(arguments);
    std::this_thread::sleep_for(time);
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << "status " << WEXITSTATUS(status);
    return WIFSIGNALED(status);
  }
};

/// How often missions are killed in all: ARIADNE_KILLS, for longer trials than that of every day.
int KillsWanted() {
  const char* wanted = std::getenv("ARIADNE_KILLS");
  return wanted == nullptr ? 12 : std::max(1, std::atoi(wanted));
}

TEST_F(Explore, KilledAtAnyMomentGoesOnToTheSameMap) {
  Must("explore rooms.yaml --out whole -q");
  RandomStream stream = NamedStream(1, "test/kill");
  for (int left = KillsWanted(); left > 0;) {
    fs::remove_all(folder_ / "killed");
    bool goes_on =
        KillAfter(std::chrono::milliseconds(50), {"explore", "rooms.yaml", "--out", "killed", "-q"});
    for (--left; left > 0 && goes_on; left -= goes_on ? 1 : 0) {
      const auto time = std::chrono::milliseconds(static_cast<int>(DrawUniform(stream, 20.0, 1500.0)));
      const bool began = fs::exists(folder_ / "killed/config.yaml");
      goes_on =
          KillAfter(time, began ? std::vector<std::string>{"explore", "--resume", "--out", "killed", "-q"}
                                : std::vector<std::string>{"explore", "rooms.yaml", "--out", "killed",
                                                           "--overwrite", "-q"});
    }
    Must("explore --resume --out killed -q");
    for (const char* name : {"map.ply", "poses.txt", "stops.csv", "metrics.json", "robot.log"})
      EXPECT_TRUE(Content(std::string("whole/") + name) == Content(std::string("killed/") + name)) << name;
  }
}

TEST_F(Explore, TellsWhereTheDiskIsFullAndGoesOnWhenItIsNot) {
  Must("explore rooms.yaml --out whole -q");
  const Ended ended = Shell("trap '' XFSZ; ulimit -f 200; ariadne explore rooms.yaml --out run -q");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.err, HasSubstr("cannot be written: File too large"));
  EXPECT_THAT(Content("run/progress.json"), HasSubstr("\"state\": \"failed\""));
  Must("explore --resume --out run -q");
  EXPECT_TRUE(Content("whole/map.ply") == Content("run/map.ply"));
  EXPECT_EQ(Content("whole/metrics.json"), Content("run/metrics.json"));
}

/// Without an answer the robot does not drive: the end of the input is that of who watches.
TEST_F(Explore, DrivesOnlyWhereItIsAllowedTo) {
  const Ended lost = Ariadne("explore rooms.yaml --out lost --approve -q");
  EXPECT_EQ(lost.status, 1);
  EXPECT_THAT(lost.out, AllOf(HasSubstr("plan: "), HasSubstr("--resume goes on")));
  const Ended once = Shell("echo yq | ariadne explore rooms.yaml --out asked --approve -q");
  EXPECT_EQ(once.status, 1);
  std::string stops = Content("asked/stops.csv");
  EXPECT_EQ(std::ranges::count(stops, '\n'), 3) << stops;  // the head, the first scan, and one more
  const Ended on = Shell("echo yyyyyyyy | ariadne explore --resume --out asked --approve -q");
  EXPECT_EQ(on.status, 0) << on.err;
  Must("explore rooms.yaml --out whole -q");
  EXPECT_TRUE(Content("whole/map.ply") == Content("asked/map.ply"));
  EXPECT_TRUE(Content("whole/robot.log") == Content("asked/robot.log"));
  const Ended no = Shell("echo n | ariadne explore rooms.yaml --out no --approve -q");
  EXPECT_EQ(no.status, 0) << no.err;
  EXPECT_THAT(no.out, HasSubstr("a plan was not approved"));
}

TEST_F(Explore, SaysWhatItCannotDo) {
  EXPECT_THAT(Ariadne("explore rooms.yaml --out run --set world=none.json -q").err, HasSubstr("none.json"));
  EXPECT_THAT(Ariadne("explore rooms.yaml --out run --set mission.limits.fence=1 -q").err,
              HasSubstr("fence"));
  EXPECT_THAT(Ariadne("explore --resume --out nothing -q").err, HasSubstr("nothing"));
  EXPECT_FALSE(fs::exists(folder_ / "run/map.ply"));
}

}  // namespace
}  // namespace ariadne
