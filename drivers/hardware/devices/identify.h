#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/serial_port.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

enum class DeviceKind { kLms200, kDynamixel, kRoboclaw, kMaestro };

/// What answers on a line.
struct FoundDevice {
  DeviceKind kind = DeviceKind::kLms200;
  int baud = 9600;
  std::string description;  // as the device puts it: its type or version, or the model and id of servos
};

/// Asks who is there, in the way of each device and at each of its rates, and changes nothing: no motor
/// moves, and what is set stays as it is. Takes up to some seconds where nobody answers.
std::optional<FoundDevice> IdentifyDevice(ByteStream& line);

/// A serial port with what answers on it, or why it could not be asked.
struct DeviceListing {
  SerialPortName port;
  std::optional<FoundDevice> device;
  std::string problem;  // a sentence; empty where the port could be asked
};

/// What `ariadne devices` shows: all ports, stable names first.
std::vector<DeviceListing> ListDevices(const std::vector<SerialPortName>& ports = ListSerialPorts());

}  // namespace ariadne::drivers

template <>
struct ariadne::EnumNames<ariadne::drivers::DeviceKind> {
  static constexpr std::array<std::string_view, 4> value = {"LMS-200", "Dynamixel", "RoboClaw", "Maestro"};
};
