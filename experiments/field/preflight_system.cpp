#include <chrono>
#include <filesystem>

#include "drivers/hardware/serial_port.h"
#include "experiments/field/preflight.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

PreflightLines::Open OpenerOf(const std::string& device, const std::string& port) {
  return [device, port]() -> std::unique_ptr<drivers::ByteStream> {
    if (port.empty())
      Fail("hardware.{}.port is not given; ariadne devices lists the ports of this computer", device);
    constexpr int kFirstBaud = 9600;  // the drivers change it
    return drivers::OpenSerialPort(port, kFirstBaud);
  };
}

/// The next folder above that exists.
fs::path ExistingFolder(fs::path path) {
  path = fs::absolute(path);
  while (!fs::exists(path) && path.has_relative_path()) path = path.parent_path();
  return path;
}

double SecondsSince1970(fs::file_time_type time) {
  return std::chrono::duration<double>(std::chrono::file_clock::to_sys(time).time_since_epoch()).count();
}

}  // namespace

PreflightLines PortsOf(const drivers::HardwareRobotOptions& robot) {
  return {OpenerOf("scanner", robot.scanner.port), OpenerOf("servo", robot.servo.port),
          OpenerOf("motors", robot.motors.port)};
}

PreflightSystem AskSystem(const std::string& out, const std::string& config) {
  PreflightSystem system;
  std::error_code error;
  const fs::space_info space = fs::space(ExistingFolder(out), error);
  if (!error) system.free_bytes = static_cast<double>(space.available);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  system.wall_time = std::chrono::duration<double>(now).count();
  if (!config.empty()) {
    const fs::file_time_type written = fs::last_write_time(config, error);
    if (!error) system.config_time = SecondsSince1970(written);
  }
  return system;
}

}  // namespace ariadne::experiments
