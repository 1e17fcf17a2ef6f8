#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/emulated/line_fault.h"
#include "drivers/emulated/robot/emulated_robot.h"
#include "drivers/simulated/load_world.h"
#include "drivers/simulated/simulated_robot.h"
#include "experiments/mission/simulated_mission.h"

namespace ariadne::experiments {

/// What `ariadne emulate` emulates.
struct EmulateOptions {
  int seed = 1;
  drivers::SimulatedRobotOptions robot = MissionRobotOptions();
  drivers::EmulatedRobotOptions emulated;
  drivers::WorldOptions geometry;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("seed", self.seed, Unit(""), Range{0, 1e9}, "of the errors of wheels and scanner");
    visit("robot", self.robot, "the base that the motors move, and the range finder in the mount");
    visit("emulated", self.emulated, "the devices");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
  }
};

/// Something that goes wrong with one of the devices, or on its line, at a time after the start [s].
struct EmulatedFault {
  enum class Device { kScanner, kServo, kMotors };
  enum class Kind {
    kLine,   // see LineFault
    kStuck,  // something holds the servo's mount for the duration
    kSlip,   // a wheel slips: so much of its way is lost for the duration
  };

  Device device = Device::kScanner;
  Kind kind = Kind::kLine;
  drivers::LineFault line;  // its time and duration are those of all kinds
  int wheel = 0;            // 0 left, 1 right
  double share = 0.5;
};

/// From "DEVICE:KIND:TIME[:AMOUNT]"; DEVICE is scanner, servo or motors, or left or right for a wheel that
/// slips. Error with what there is.
EmulatedFault ParseEmulatedFault(const std::string& text);

/// The names of the three pseudo-terminals.
struct EmulatedPorts {
  std::string scanner;
  std::string servo;
  std::string motors;
};

/// What became of the robot.
struct EmulationEnd {
  double time = 0.0;  // since the start [s]
  double path = 0.0;  // truly driven [m]
  int collisions = 0;
  slam::Pose2 T_world_base;
  std::vector<drivers::TruePose> way_world;  // one per step in which it moved, and one before it began to
};

/// Emulates the devices of a robot in a world, in real time, each on a pseudo-terminal of its own, as long
/// as `goes_on`. `on_ready` hears where they are.
EmulationEnd Emulate(const std::string& world, const EmulateOptions& options,
                     const std::vector<EmulatedFault>& faults,
                     const std::function<void(const EmulatedPorts&)>& on_ready,
                     const std::function<bool(double now)>& goes_on);

}  // namespace ariadne::experiments
