#include <algorithm>
#include <filesystem>
#include <set>

#include "drivers/hardware/serial_port.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

/// The entries of a folder in their order; none where there is no such folder.
std::vector<fs::path> EntriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool IsSerialDevice(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto begins = [&](const char* prefix) { return name.rfind(prefix, 0) == 0; };
  return begins("ttyUSB") || begins("ttyACM") || begins("ttyAMA") || begins("ttyS");
}

}  // namespace

std::vector<SerialPortName> ListSerialPorts(const std::string& dev) {
  std::vector<SerialPortName> ports;
  std::set<std::string> known;
  const auto add = [&](const fs::path& path) {
    std::error_code error;
    const fs::path device = fs::canonical(path, error);
    if (!error && known.insert(device.string()).second) ports.push_back({path.string(), device.string()});
  };
  for (const char* folder : {"serial/by-id", "serial/by-path"}) {
    for (const fs::path& path : EntriesOf(fs::path(dev) / folder)) add(path);
  }
  for (const fs::path& path : EntriesOf(dev)) {
    if (IsSerialDevice(path)) add(path);
  }
  return ports;
}

}  // namespace ariadne::drivers
