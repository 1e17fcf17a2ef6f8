#include "experiments/studies/emulate.h"

#include <array>
#include <charconv>
#include <string_view>

#include "drivers/emulated/pty_server.h"
#include "experiments/run/data_path.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using drivers::LineFault;
using drivers::PtyServer;

[[noreturn]] void FailFault(const std::string& text) {
  Fail(
      "--fault {}: expected DEVICE:KIND:TIME[:AMOUNT], with DEVICE scanner, servo or motors and KIND drop, "
      "flip, duplicate (AMOUNT bytes), delay, dead, power (AMOUNT s); or servo:stuck:TIME:SECONDS; or "
      "left:slip:TIME:SECONDS, right:slip:TIME:SECONDS; as in scanner:power:20:3",
      text);
}

std::vector<std::string> SplitAtColons(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double NumberOfFault(const std::string& number, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc{} || end != number.data() + number.size() || !(value >= 0.0) || value > 1e6)
    FailFault(text);
  return value;
}

void SetKind(EmulatedFault& fault, const std::string& kind, const std::string& text) {
  constexpr std::array<std::string_view, LineFault::kKinds> kKinds{"drop",  "flip", "duplicate",
                                                                   "delay", "dead", "power"};
  const bool wheel = text.starts_with("left:") || text.starts_with("right:");
  if (wheel != (kind == "slip")) FailFault(text);
  if (kind == "slip") {
    fault.kind = EmulatedFault::Kind::kSlip;
  } else if (kind == "stuck" && fault.device == EmulatedFault::Device::kServo) {
    fault.kind = EmulatedFault::Kind::kStuck;
  } else {
    const auto known = std::find(kKinds.begin(), kKinds.end(), kind);
    if (known == kKinds.end()) FailFault(text);
    fault.line.kind = static_cast<LineFault::Kind>(known - kKinds.begin());
  }
}

}  // namespace

EmulatedFault ParseEmulatedFault(const std::string& text) {
  const std::vector<std::string> parts = SplitAtColons(text);
  if (parts.size() < 3 || parts.size() > 4) FailFault(text);
  EmulatedFault fault;
  const std::string& device = parts[0];
  if (device == "servo") {
    fault.device = EmulatedFault::Device::kServo;
  } else if (device == "motors" || device == "left" || device == "right") {
    fault.device = EmulatedFault::Device::kMotors;
  } else if (device != "scanner") {
    FailFault(text);
  }
  fault.wheel = device == "right" ? 1 : 0;
  SetKind(fault, parts[1], text);
  fault.line.time = NumberOfFault(parts[2], text);
  const double amount = parts.size() == 4 ? NumberOfFault(parts[3], text) : 1.0;
  fault.line.duration = amount;
  fault.line.count = static_cast<int>(amount);
  return fault;
}

namespace {

/// Faults of devices begin and end while the others are served.
class DeviceFaults {
 public:
  DeviceFaults(drivers::EmulatedRobot& robot, const std::vector<EmulatedFault>& faults)
      : robot_(robot), faults_(faults) {}

  void Update(double now) {
    bool stuck = false;
    std::array<double, 2> slip{};
    for (const EmulatedFault& fault : faults_) {
      if (now < fault.line.time || now >= fault.line.time + fault.line.duration) continue;
      stuck = stuck || fault.kind == EmulatedFault::Kind::kStuck;
      if (fault.kind == EmulatedFault::Kind::kSlip)
        slip[static_cast<std::size_t>(fault.wheel)] = fault.share;
    }
    robot_.SetStuck(stuck);
    for (int wheel = 0; wheel < 2; ++wheel) robot_.SetSlip(wheel, slip[static_cast<std::size_t>(wheel)]);
  }

 private:
  drivers::EmulatedRobot& robot_;
  const std::vector<EmulatedFault>& faults_;
};

double LengthOf(const std::vector<drivers::TruePose>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += (path[i].T_map_base.translation - path[i - 1].T_map_base.translation).norm();
  return length;
}

}  // namespace

EmulationEnd Emulate(const std::string& world, const EmulateOptions& options,
                     const std::vector<EmulatedFault>& faults,
                     const std::function<void(const EmulatedPorts&)>& on_ready,
                     const std::function<bool(double now)>& goes_on) {
  CheckOptions(options);
  const auto scene = std::make_shared<const drivers::RayScene>(
      drivers::LoadWorld(ExpandDataPath(world).string(), options.geometry));
  drivers::EmulatedRobot robot(scene, options.robot.base, options.robot.ais, options.emulated,
                               static_cast<std::uint64_t>(options.seed));
  PtyServer scanner(robot.scanner());
  PtyServer servo(robot.mount(), scanner), motors(robot.motors(), scanner);
  const std::array<PtyServer*, 3> servers{&scanner, &servo, &motors};
  robot.SetCatchUp([&servo, &motors](double time) {
    servo.CatchUp(time);
    motors.CatchUp(time);
  });
  for (const EmulatedFault& fault : faults) {
    if (fault.kind == EmulatedFault::Kind::kLine)
      servers[static_cast<std::size_t>(fault.device)]->Inject(fault.line);
  }
  DeviceFaults device_faults(robot, faults);
  on_ready({scanner.path(), servo.path(), motors.path()});
  PtyServer::ServeAll(servers, [&](double now) {
    device_faults.Update(now);
    return goes_on(now);
  });
  const std::vector<drivers::TruePose>& way_world = robot.base().path_true();
  return {scanner.Now(), LengthOf(way_world), static_cast<int>(robot.base().collisions().size()),
          robot.base().T_map_base_true(), way_world};
}

}  // namespace ariadne::experiments
