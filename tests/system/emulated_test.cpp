// The drivers of the real robot: on emulated devices within the program, and over pseudo-terminals.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "drivers/emulated/pty_server.h"
#include "drivers/emulated/robot/emulated_robot.h"
#include "drivers/simulated/load_world.h"
#include "slam/io/trajectory.h"
#include "tests/system/program.h"
#include "tests/system/rooms.h"

namespace ariadne {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Longer than on a robot: other work slows a machine that tests.
const std::vector<std::string> kPatient{"--set", "hardware.motors.timeout=0.5",
                                        "--set", "hardware.motors.reply_time=0.3",
                                        "--set", "hardware.servo.reply_time=0.2"};

class Emulated : public ProgramTest {
 protected:
  void SetUp() override {
    folder_.Write("rooms.json", kTwoRoomsPlan);
    folder_.Write("rooms.yaml", RoomsConfig(3));
  }

  /// Starts `ariadne emulate`; its ports by their names. It ends by EndEmulation.
  std::map<std::string, std::string> StartEmulation() {
    emulation_ = Start({"emulate", "rooms.json", "--set", "geometry.plan.thickness=0.3", "--ports",
                        (folder_ / "ports.txt").string(), "--truth", (folder_ / "truth.tum").string()});
    std::map<std::string, std::string> ports;
    for (int i = 0; i < 200 && !ports.contains("motors"); ++i) {
      std::this_thread::sleep_for(milliseconds(50));
      if (!fs::exists(folder_ / "ports.txt")) continue;
      std::istringstream lines(Content("ports.txt"));
      for (std::string name, port; lines >> name >> port;) ports[name] = port;
    }
    EXPECT_EQ(ports.size(), 3U);
    return ports;
  }
  int EndEmulation() const {
    kill(emulation_, SIGINT);
    int status = -1;
    waitpid(emulation_, &status, 0);
    return status;
  }

  static std::vector<std::string> OnPorts(std::map<std::string, std::string> ports,
                                          const std::string& out) {
    std::vector<std::string> arguments{"explore", "rooms.yaml", "--out",         out,
                                       "-q",      "--set",      "robot=hardware"};
    for (const char* device : {"scanner", "servo", "motors"}) {
      arguments.insert(arguments.end(),
                       {"--set", "hardware." + std::string(device) + ".port=" + ports[device]});
    }
    arguments.insert(arguments.end(), kPatient.begin(), kPatient.end());
    return arguments;
  }

  pid_t emulation_ = -1;
};

std::vector<slam::StampedPose> ReadPoses(const std::string& text) {
  std::istringstream in(text);
  return slam::ReadTum(in, "poses");
}

/// How far from the truth, which is of the base, the scanner's way ends, if both begin at one place [m].
double ErrorAtTheEnd(const std::vector<slam::StampedPose>& poses,
                     const std::vector<slam::StampedPose>& truth) {
  slam::Pose3 T_base_laser;
  T_base_laser.translation.x() = 0.25;  // hardware.mount.x
  const slam::Pose3 moved = T_base_laser * poses.front().pose.Inverse() * poses.back().pose;
  const slam::Pose3 moved_truly = truth.front().pose.Inverse() * truth.back().pose * T_base_laser;
  return (moved.translation - moved_truly.translation).norm();
}

nlohmann::json Metrics(const std::string& text) { return nlohmann::json::parse(text); }

TEST_F(Emulated, MissionIsJudgedAndRepeatsItself) {
  Must("explore rooms.yaml --set robot=emulated --out one -q");
  Must("explore rooms.yaml --set robot=emulated --set threads=1 --out two -q");
  const nlohmann::json metrics = Metrics(Content("one/metrics.json"));
  EXPECT_EQ(metrics["scans"], 3);
  EXPECT_EQ(metrics["refused"], 0);
  EXPECT_LT(metrics["translation_rms_m"], 0.03);
  EXPECT_LT(metrics["map_error_mean_m"], 0.02);
  EXPECT_GT(metrics["path_m"], 0.5);
  EXPECT_THAT(Content("one/config.yaml"), HasSubstr("kind: emulated"));
  for (const char* name : {"map.ply", "stops.csv", "metrics.json", "robot.log", "lines.log.000"})
    EXPECT_TRUE(Content(std::string("one/") + name) == Content(std::string("two/") + name)) << name;
}

/// A run that was killed does all once more, and ends as one that was not.
TEST_F(Emulated, KilledMissionGoesOn) {
  Must("explore rooms.yaml --set robot=emulated --out whole -q");
  const pid_t child = Start({"explore", "rooms.yaml", "--set", "robot=emulated", "--out", "killed", "-q"});
  for (int i = 0; i < 1000 && !fs::exists(folder_ / "killed/scans/scan001.pose"); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  Must("explore --resume --out killed -q");
  for (const char* name : {"map.ply", "metrics.json", "robot.log", "lines.log.000"})
    EXPECT_TRUE(Content(std::string("whole/") + name) == Content(std::string("killed/") + name)) << name;
}

TEST_F(Emulated, SaysWhatItNeeds) {
  EXPECT_THAT(Ariadne("explore rooms.yaml --set robot=hardware --out run -q").err,
              HasSubstr("hardware.scanner.port is not given"));
  EXPECT_THAT(Ariadne("explore rooms.yaml --set robot=real --out run -q").err,
              HasSubstr("must be one of simulated, emulated, hardware"));
  EXPECT_THAT(Ariadne("emulate rooms.json --fault scanner:melts:3").err,
              HasSubstr("--fault scanner:melts:3: expected DEVICE:KIND:TIME"));
  EXPECT_THAT(Ariadne("emulate nowhere.json").err, HasSubstr("nowhere.json"));
}

/// The whole chain in real time, with two scans and a signal between them; both starts are replayed.
TEST_F(Emulated, IsExploredOverPorts) {
  const auto ports = StartEmulation();
  std::vector<std::string> arguments = OnPorts(ports, "run");
  arguments.insert(arguments.end(), {"--set", "mission.limits.max_scans=2"});
  const pid_t child = Start(arguments);
  for (int i = 0; i < 3000 && !fs::exists(folder_ / "run/scans/scan000.pose"); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  kill(child, SIGTERM);
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 1 << 8) << "it was stopped";
  EXPECT_THAT(Ariadne("explore --resume --out run").err,
              HasSubstr("the motor board stops the wheels 0.5 s after the last command"));
  EXPECT_EQ(EndEmulation(), 0);
  const auto truth = ReadPoses(Content("truth.tum"));
  ASSERT_GT(truth.size(), 100U);
  EXPECT_LT(ErrorAtTheEnd(ReadPoses(Content("run/trajectory.tum")), truth), 0.03);
  const nlohmann::json metrics = Metrics(Content("run/metrics.json"));
  EXPECT_EQ(metrics["scans"], 2);
  EXPECT_EQ(metrics["refused"], 0);
  EXPECT_GT(Content("run/lines.log.000").size(), 100000U);
  EXPECT_GT(Content("run/map.ply").size(), 100000U);
  const std::string replayed = Must("replay run -q");
  EXPECT_THAT(replayed, HasSubstr("lines.log: 1 scans, "));
  EXPECT_THAT(replayed, HasSubstr("all the same\nthe mission ended as it did: it was stopped\n"));
  EXPECT_THAT(replayed, HasSubstr("lines-2.log: 2 scans, "));
  EXPECT_THAT(replayed,
              HasSubstr("all the same\nthe mission ended as it did: the limit of scans is reached\n"));
}

/// Stopped by a signal while it drives: in order, and with wheels that stand.
TEST_F(Emulated, StopsTheWheelsWhenItIsKilled) {
  for (const int signal : {SIGKILL, SIGTERM}) {
    drivers::World world = drivers::LoadWorld((folder_ / "rooms.json").string());
    const auto scene = std::make_shared<drivers::RayScene>(std::move(world));
    drivers::EmulatedRobot robot(scene, {}, {}, {}, 1);
    drivers::PtyServer scanner(robot.scanner());
    drivers::PtyServer servo(robot.servo(), scanner), motors(robot.motors(), scanner);
    robot.SetCatchUp([&](double time) {
      servo.CatchUp(time);
      motors.CatchUp(time);
    });
    const std::array<drivers::PtyServer*, 3> servers{&scanner, &servo, &motors};
    const std::string out = "killed" + std::to_string(signal);
    const pid_t child = Start(
        OnPorts({{"scanner", scanner.path()}, {"servo", servo.path()}, {"motors", motors.path()}}, out));
    double killed_at = 0.0, stood_at = 0.0, rolled_at = 0.0;
    drivers::PtyServer::ServeAll(servers, [&](double now) {
      const auto& speeds = robot.motors().speeds();
      const double speed = std::max(std::abs(speeds[0]), std::abs(speeds[1]));
      if (speed > 0.0) rolled_at = now;
      if (killed_at == 0.0 && speed > 500.0) {
        kill(child, signal);
        killed_at = now;
      }
      if (killed_at > 0.0 && speed == 0.0 && stood_at == 0.0) stood_at = now;
      return now < 60.0 && (killed_at == 0.0 || now < killed_at + 1.5);
    });
    waitpid(child, nullptr, 0);
    ASSERT_GT(killed_at, 0.0);
    ASSERT_GT(stood_at, 0.0);
    EXPECT_LT(stood_at - killed_at, 0.5 + 0.1);  // the timeout of kPatient
    EXPECT_LT(rolled_at, stood_at);              // and it stays so
    EXPECT_GT(Content(out + "/lines.log.000").size(), 10000U);
    EXPECT_THAT(
        Must("replay -q " + out),
        HasSubstr(signal == SIGKILL ? "all the same\nthe recording ends there\n"
                                    : "all the same\nthe mission ended as it did: it was stopped\n"));
  }
}

}  // namespace
}  // namespace ariadne
