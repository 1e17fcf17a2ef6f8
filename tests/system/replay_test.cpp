// The drivers and the mission once more on what was recorded of the lines.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/system/program.h"
#include "tests/system/rooms.h"

namespace ariadne {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Replay : public ProgramTest {
 protected:
  void SetUp() override {
    folder_.Write("rooms.json", kTwoRoomsPlan);
    folder_.Write("rooms.yaml", RoomsConfig(3, "robot: emulated\n"));
  }
  void Tear(const std::string& file, std::uintmax_t bytes) const {
    fs::resize_file(folder_ / file, fs::file_size(folder_ / file) - bytes);
  }
};

TEST_F(Replay, DecidesTheSameOnceMore) {
  Must("explore rooms.yaml --out run -q");
  EXPECT_THAT(
      Must("replay run"),
      AllOf(HasSubstr("lines.log: 3 scans, "),
            HasSubstr("all the same\nthe mission ended as it did: the limit of scans is reached\n")));
  Tear("run/lines.log.000", 3);  // in the last record: the wheels are told to stop, after the end
  EXPECT_THAT(Must("replay run/lines.log -q"), AllOf(HasSubstr("3 scans, "), HasSubstr("all the same\n")));
  Tear("run/lines.log.000", fs::file_size(folder_ / "run/lines.log.000") / 2);
  EXPECT_THAT(Must("replay run/lines.log.000 -q"), HasSubstr("all the same\nthe recording ends there\n"));
}

/// Where it would do something else, it says what was recorded.
TEST_F(Replay, SaysWhereDecisionsDiffer) {
  Must("explore rooms.yaml --set mission.limits.max_scans=2 --out run -q");
  const Ended plan = Ariadne("replay run -q --set seed=2");
  EXPECT_EQ(plan.status, 1);
  EXPECT_THAT(plan.out, AllOf(HasSubstr("run/lines.log: 1 scans, "), HasSubstr("and then NOT\n"),
                              HasSubstr("steps/step000.json: next_view was recorded as {\"place\":["),
                              HasSubstr("; now {\"place\":[")));
  const Ended lines = Ariadne("replay run -q --set hardware.servo.zero=181");
  EXPECT_EQ(lines.status, 1);
  EXPECT_THAT(lines.out,
              AllOf(HasSubstr("0 scans, "), HasSubstr("was recorded as the emulated servo's line"),
                    HasSubstr("now the emulated servo's line is written FF FF FD")));
  const Ended answer = Ariadne("replay run -q --set hardware.drive.wheel_radius=0.11");
  EXPECT_EQ(answer.status, 1);
  EXPECT_THAT(answer.out, HasSubstr("being written 80 28"));
  const Ended longer = Ariadne("replay run -q --set mission.limits.max_scans=1");
  EXPECT_EQ(longer.status, 1);
  EXPECT_THAT(longer.out,
              AllOf(HasSubstr("NOT\n"), HasSubstr("metrics.json: scans was recorded as 2; now 1\n")));
}

TEST_F(Replay, EndsWhereTheRunWasKilledOrStopped) {
  for (const int signal : {SIGKILL, SIGTERM}) {
    const std::string run = "ended" + std::to_string(signal);
    const pid_t child = Start({"explore", "rooms.yaml", "--out", run, "-q"});
    for (int i = 0; i < 3000 && !fs::exists(folder_ / run / "scans/scan001.pose"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(child, signal);
    waitpid(child, nullptr, 0);
    EXPECT_THAT(Must("replay -q " + run),
                AllOf(HasSubstr("2 scans, "),
                      HasSubstr(signal == SIGKILL
                                    ? "all the same\nthe recording ends there\n"
                                    : "all the same\nthe mission ended as it did: it was stopped\n")));
  }
}

/// What a person has refused is on the record as well.
TEST_F(Replay, RefusesWhatWasRefused) {
  const Ended refused = Shell("echo yn | ariadne explore rooms.yaml --out run --approve -q");
  ASSERT_EQ(refused.status, 0) << refused.err;
  EXPECT_THAT(Must("replay -q run"),
              AllOf(HasSubstr("2 scans, "),
                    HasSubstr("all the same\nthe mission ended as it did: a plan was not approved\n")));
}

/// A servo that measures nothing tilts the scanner.
TEST_F(Replay, DecidesTheSameWithAHobbyServo) {
  Must(
      "explore rooms.yaml --set hardware.servo_kind=hobby --set hardware.tilt.from=-0.9 "
      "--set hardware.tilt.to=0.9 --out run -q");
  const nlohmann::json metrics = nlohmann::json::parse(Content("run/metrics.json"));
  EXPECT_EQ(metrics["scans"], 3);
  EXPECT_EQ(metrics["refused"], 0);
  EXPECT_LT(metrics["translation_rms_m"], 0.05);
  EXPECT_LT(metrics["map_error_mean_m"], 0.03);
  EXPECT_THAT(Must("replay run -q"), AllOf(HasSubstr("3 scans, "), HasSubstr("all the same\n")));
  EXPECT_THAT(Must("log info run"), HasSubstr("aestro"));
}

TEST_F(Replay, SaysWhatItNeeds) {
  EXPECT_EQ(Ariadne("replay").status, 2);
  EXPECT_THAT(Ariadne("replay nowhere").err, HasSubstr("there is no such log or folder"));
  folder_.Write("lines/lines.log.000", "ARIADLN2");
  EXPECT_THAT(Ariadne("replay lines").err, HasSubstr("config.yaml; a replay needs the whole directory"));
  Must("explore rooms.yaml --set robot=simulated --set mission.limits.max_scans=1 --out run -q");
  EXPECT_THAT(Ariadne("replay run").err, HasSubstr("holds no logs of lines"));
}

}  // namespace
}  // namespace ariadne
