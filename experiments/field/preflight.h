#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/hardware/robot/hardware_robot.h"
#include "experiments/field/preflight_options.h"

namespace ariadne::experiments {

/// One line of the list: green with what was found, or red with a sentence that says what to do.
struct PreflightItem {
  std::string name;
  bool ok = false;
  std::string text;
};

/// How the lines to the devices are opened; each is opened once.
struct PreflightLines {
  using Open = std::function<std::unique_ptr<drivers::ByteStream>()>;
  Open scanner, servo, motors;
};

/// What is told about the computer.
struct PreflightSystem {
  double free_bytes = 0.0;   // on the disk of the run
  double wall_time = 0.0;    // of its clock, since 1970 [s]
  double config_time = 0.0;  // when the configuration was written, since 1970 [s]
};

/// Goes through the list: computer, devices one by one, battery, emergency stop, and, where all devices
/// answer, the robot that they make: a level sweep, and a 3D scan whose floor must be where the mount says.
/// No wheel turns; the scanner's mount does. Throws nothing that a device can be the reason for. `show` is
/// told each item as it is known, and what is under way.
std::vector<PreflightItem> CheckRobot(const drivers::HardwareRobotOptions& robot,
                                      const PreflightOptions& options, const PreflightLines& lines,
                                      const PreflightSystem& system,
                                      const std::function<void(const std::string&)>& on_status = {});

/// The ports that the options name.
PreflightLines PortsOf(const drivers::HardwareRobotOptions& robot);

/// `out` is where the run is to go, `config` the file, if there is one.
PreflightSystem AskSystem(const std::string& out, const std::string& config);

std::string ToText(const std::vector<PreflightItem>& items);

}  // namespace ariadne::experiments
