#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "drivers/emulated/robot/emulated_robot.h"
#include "drivers/hardware/line_log.h"
#include "drivers/hardware/recorded_lines.h"
#include "drivers/hardware/robot/hardware_robot.h"
#include "drivers/replay/replay_robot.h"
#include "drivers/safety/guarded_robot.h"
#include "drivers/simulated/simulated_robot.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// What explores.
enum class RobotKind {
  kSimulated,  // a robot without devices
  kEmulated,   // the real robot's drivers, on emulated devices in a simulated world, in virtual time
  kHardware    // the real robot's drivers, on ports
};

/// The simulated robot, which is also what an emulated one is in its world, and which of them explores.
struct ExploringRobotOptions : drivers::SimulatedRobotOptions {
  RobotKind kind = RobotKind::kSimulated;
  drivers::GuardOptions guard = {};

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("kind", self.kind,
          "simulated, without devices; emulated: the drivers of the real one talk to emulated devices, in "
          "virtual time; hardware: they talk to ports. `robot: emulated` is short for it");
    visit("guard", self.guard,
          "when the wheels of a robot on ports are stopped, whatever the mission wants");
    drivers::SimulatedRobotOptions::Visit(self, visit);
  }
};

/// Scans like those of MissionRobotOptions.
drivers::HardwareRobotOptions MissionHardwareOptions();

/// Where a run keeps what crossed the lines to the devices.
constexpr const char* kLineLog = "lines.log";

/// The robot that a mission drives, of whatever kind.
class ExploredRobot {
 public:
  virtual ~ExploredRobot() = default;

  virtual drivers::Robot& robot() = 0;

  /// Where it truly is; none for a real one.
  virtual const drivers::SimulatedBase* truth() const = 0;

  /// Before anything else: brings it to where the log of a run that is resumed ends, and says what lies
  /// between. A real one stands where it is.
  virtual drivers::Seam Resume(drivers::RobotLog& log) = 0;

  /// Into the log of the lines, if there is one.
  virtual void Note(const std::string&) {}
};

/// What crosses the lines of a robot of devices is kept in the run, if there is one. `scene` is not used
/// for a real robot, whose devices must answer: Error that says which does not. Its wheels are stopped
/// where `stop` says so, and stay so.
std::unique_ptr<ExploredRobot> MakeExploredRobot(const ExploringRobotOptions& robot,
                                                 const drivers::HardwareRobotOptions& hardware,
                                                 const drivers::EmulatedRobotOptions& emulated,
                                                 std::shared_ptr<const drivers::RayScene> scene,
                                                 std::uint64_t seed, const RunDirectory* run,
                                                 const std::function<bool()>& stop = {});

/// The drivers of a robot of devices on lines that were recorded.
std::unique_ptr<ExploredRobot> MakeReplayedRobot(const ExploringRobotOptions& robot,
                                                 const drivers::HardwareRobotOptions& hardware,
                                                 drivers::RecordedLines& lines,
                                                 const std::function<bool()>& stop);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::RobotKind> {
  static constexpr std::array<std::string_view, 3> value{"simulated", "emulated", "hardware"};
};

}  // namespace ariadne
