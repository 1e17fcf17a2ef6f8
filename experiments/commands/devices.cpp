#include "drivers/hardware/devices/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/report/table.h"
#include "experiments/run/progress_display.h"

namespace ariadne::experiments {
namespace {

using drivers::DeviceListing;
using drivers::SerialPortName;

struct DevicesArguments {
  std::vector<std::string> ports;
  bool quiet = false;
};

std::vector<SerialPortName> PortsOf(const std::vector<std::string>& paths) {
  std::vector<SerialPortName> ports;
  for (const std::string& path : paths) {
    std::error_code error;
    const std::filesystem::path device = std::filesystem::canonical(path, error);
    ports.push_back({path, error ? path : device.string()});
  }
  return ports;
}

/// What is known of a port, a row.
std::vector<std::string> DeviceRow(const DeviceListing& listing) {
  const std::string port = listing.port.path == listing.port.device
                               ? listing.port.path
                               : fmt::format("{} ({})", listing.port.path, listing.port.device);
  if (!listing.problem.empty()) return {port, "-", "-", listing.problem};
  if (!listing.device) return {port, "none", "-", "nothing that is known here answers; is it switched on?"};
  return {port, std::string(NameOf(listing.device->kind)), std::to_string(listing.device->baud),
          listing.device->description};
}

/// 1 where a port that was asked for by name has no device.
int PrintDevices(const DevicesArguments& arguments) {
  const std::vector<SerialPortName> ports =
      arguments.ports.empty() ? drivers::ListSerialPorts() : PortsOf(arguments.ports);
  if (ports.empty()) {
    fmt::print("this computer has no serial ports; plug the adapter in, or name a port: {}\n",
               "ariadne devices /dev/...");
    return 0;
  }
  ProgressDisplay progress(arguments.quiet);
  Table table{{"port", "device", "baud", "it says"}, {}};
  bool all = true;
  for (const SerialPortName& port : ports) {
    progress.Show(fmt::format("asking {} ({} of {})", port.path, table.rows.size() + 1, ports.size()));
    const DeviceListing listing = drivers::ListDevices({port}).front();
    table.rows.push_back(DeviceRow(listing));
    all = all && listing.device.has_value();
  }
  progress.Keep("");
  fmt::print("{}", ToText(table));
  return arguments.ports.empty() || all ? 0 : 1;
}

}  // namespace

void AddDevicesCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("devices", "List the serial ports, with what answers on each; nothing moves");
  auto arguments = std::make_shared<DevicesArguments>();
  command->add_option("ports", arguments->ports, "Ports to ask; without any: all of this computer");
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on stderr");
  command->footer(
      "A silent port takes some seconds, as each device is asked at each of its rates. Use the\n"
      "stable names (/dev/serial/by-id/...) in configurations: they outlast plugging in again.\n"
      "Example:\n"
      "  ariadne devices /dev/ttyUSB0 /dev/pts/5\n"
      "Exit status: 0; 1 if a port that was named has no device that answers; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = PrintDevices(*arguments); });
}

}  // namespace ariadne::experiments
