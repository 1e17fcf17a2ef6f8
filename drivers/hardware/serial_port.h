#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/hardware/byte_stream.h"

namespace ariadne::drivers {

/// Opens a serial port (or a pseudo-terminal) with 8 data bits, no parity, 1 stop bit, no handshake. `baud`
/// is 9600 to 500000. Its clock is the system's monotonic one. Error that names the port and what to do
/// when there is none, when another program has it, or when it cannot have the rate.
std::unique_ptr<ByteStream> OpenSerialPort(const std::string& path, int baud);

/// A port that a configuration may name.
struct SerialPortName {
  std::string path;    // stable where the system gives one: /dev/serial/by-id/...
  std::string device;  // what it stands for now: /dev/ttyUSB0
};

/// The serial ports of this computer, stable names first, each device once. `dev` is where devices are.
std::vector<SerialPortName> ListSerialPorts(const std::string& dev = "/dev");

}  // namespace ariadne::drivers
