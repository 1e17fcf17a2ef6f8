#include "experiments/field/preflight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/calibration/calibration_planes.h"
#include "experiments/field/floor_check.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kGigabyte = 1e9;
constexpr double kYear2024 = 1704067200.0;  // since 1970 [s]
constexpr double kPollStop = 0.1;           // [s]

/// A line that several drivers use, one after another.
class SharedLine : public drivers::ByteStream {
 public:
  explicit SharedLine(std::shared_ptr<drivers::ByteStream> line) : line_(std::move(line)) {}
  std::string name() const override { return line_->name(); }
  double Now() const override { return line_->Now(); }
  drivers::Bytes Read(double deadline) override { return line_->Read(deadline); }
  void Write(drivers::ByteView bytes) override { line_->Write(bytes); }
  void SetBaud(int baud) override { line_->SetBaud(baud); }
  int baud() const override { return line_->baud(); }

 private:
  std::shared_ptr<drivers::ByteStream> line_;
};

/// The list while it grows.
class Preflight {
 public:
  Preflight(const drivers::HardwareRobotOptions& robot, const PreflightOptions& options,
            const std::function<void(const std::string&)>& on_status)
      : robot_(robot), options_(options), on_status_(on_status) {
    robot_.scanner.recovery_time = std::min(robot_.scanner.recovery_time, options.patience);
  }

  void CheckSystem(const PreflightSystem& system);
  void CheckMount();
  void CheckDevices(const PreflightLines& lines);
  void CheckWhole();
  std::vector<PreflightItem> items;

 private:
  /// Red where the action throws; else what it returns.
  template <typename Action>
  bool Try(const std::string& name, const Action& action) {
    if (on_status_) on_status_(name);
    try {
      items.push_back({name, true, action()});
    } catch (const Error& error) {
      items.push_back({name, false, error.what()});
    }
    return items.back().ok;
  }
  std::unique_ptr<drivers::ByteStream> Line(std::size_t device) const {
    return std::make_unique<SharedLine>(lines_[device]);
  }
  std::string AskScanner();
  std::string AskServo();
  std::string AskMotors();
  std::string TryStop();
  std::string LevelSweep(drivers::HardwareRobot& robot) const;
  std::string FloorOf(drivers::HardwareRobot& robot) const;

  drivers::HardwareRobotOptions robot_;
  const PreflightOptions& options_;
  const std::function<void(const std::string&)>& on_status_;
  std::array<std::shared_ptr<drivers::ByteStream>, 3> lines_;  // scanner, servo, motors
  std::unique_ptr<drivers::roboclaw::Motors> motors_;
};

void Preflight::CheckSystem(const PreflightSystem& system) {
  Try("disk space", [&] {
    const double free = system.free_bytes / kGigabyte;
    if (free < options_.min_free)
      Fail("{:.1f} GB are free, fewer than {}; make room, or choose another --out", free,
           options_.min_free);
    return fmt::format("{:.0f} GB are free", free);
  });
  Try("clock", [&] {
    if (system.wall_time < kYear2024)
      Fail("the computer's clock is before 2024; set it, or join a network");
    if (system.wall_time < system.config_time)
      Fail("the computer's clock is before the time of the configuration; set it, or join a network");
    return std::string("later than the configuration");
  });
}

void Preflight::CheckMount() {
  Try("calibration", [&] {
    const drivers::LaserMountOptions& mount = robot_.mount;
    if (mount.roll == 0.0 && mount.pitch == 0.0 && !options_.uncalibrated) {
      Fail(
          "hardware.mount has neither roll nor pitch; run ariadne calibrate scanner, or set "
          "check.uncalibrated for its first scans");
    }
    if (robot_.drive.track < 2.0 * robot_.drive.wheel_radius)
      Fail("hardware.drive: wheels of {} m do not fit into a track of {} m", robot_.drive.wheel_radius,
           robot_.drive.track);
    return fmt::format("roll {:.2f} deg, pitch {:.2f} deg, wheels 1 : {:.4f}, track {:.3f} m",
                       slam::DegFromRad(mount.roll), slam::DegFromRad(mount.pitch),
                       robot_.drive.radius_ratio, robot_.drive.track);
  });
}

std::string Preflight::AskScanner() {
  drivers::Lms200 scanner(Line(0), robot_.scanner);
  scanner.Connect();
  const drivers::lms200::StatusReply status = scanner.AskStatus();
  const drivers::lms200::DeviceStatus device = drivers::lms200::DeviceStatusOf(status.status);
  if (device.polluted) Fail("the front window of the scanner is dirty; clean it with a soft cloth");
  if (status.error >= 3) Fail("the scanner reports error {}; switch it off and on", status.error);
  return fmt::format("{}, {} baud, {} errors in its memory", scanner.type(), status.baud,
                     scanner.AskErrors().size());
}

std::string Preflight::AskServo() {
  const std::unique_ptr<drivers::TiltMount> mount = drivers::MakeTiltMount(Line(1), robot_);
  mount->Connect();
  return mount->Describe();
}

std::string Preflight::AskMotors() {
  motors_ = std::make_unique<drivers::roboclaw::Motors>(Line(2), robot_.motors);
  motors_->Connect();
  return fmt::format("{}, stops by itself after {} s", motors_->version(), robot_.motors.timeout);
}

/// Of the board's own input, which works without this program.
std::string Preflight::TryStop() {
  constexpr std::string_view kBit = "emergency stop";
  const auto pressed = [&] { return motors_->Warnings().find(kBit) != std::string::npos; };
  if (pressed()) Fail("the emergency stop is pressed; release it");
  if (options_.press_stop == 0.0)
    return "released; check.press_stop tries it (otherwise do: lift the robot, press it while it drives)";
  const std::unique_ptr<drivers::ByteStream> line = Line(2);
  for (const bool wanted : {true, false}) {
    if (on_status_) on_status_(wanted ? "press the emergency stop now" : "release the emergency stop now");
    const double give_up = line->Now() + options_.press_stop;
    while (pressed() != wanted) {
      if (line->Now() > give_up)
        Fail("the motor board has not seen the emergency stop {} within {} s; see its wires",
             wanted ? "pressed" : "released", options_.press_stop);
      drivers::DiscardUntil(*line, line->Now() + kPollStop);
    }
  }
  return "was pressed and released";
}

void Preflight::CheckDevices(const PreflightLines& lines) {
  const bool scanner = Try("scanner", [&] {
    lines_[0] = lines.scanner();
    return AskScanner();
  });
  const bool servo = Try("servo", [&] {
    lines_[1] = lines.servo();
    return AskServo();
  });
  const bool motors = Try("motor board", [&] {
    lines_[2] = lines.motors();
    return AskMotors();
  });
  if (motors) {
    Try("battery", [&] {
      const double volts = motors_->Battery();
      if (volts < options_.min_battery)
        Fail("{:.1f} V are too few (fewer than {}); charge the battery", volts, options_.min_battery);
      if (volts > options_.max_battery)
        Fail("{:.1f} V are too many (more than {}); see the charger", volts, options_.max_battery);
      return fmt::format("{:.1f} V", volts);
    });
    Try("emergency stop", [&] { return TryStop(); });
    Try("warnings", [&] {
      const std::string warnings = motors_->Warnings();
      if (!warnings.empty()) Fail("the motor board reports {}", warnings);
      return std::string("the motor board has none");
    });
  }
  if (scanner && servo && motors) CheckWhole();
}

std::string Preflight::LevelSweep(drivers::HardwareRobot& robot) const {
  const slam::LaserSweep sweep = robot.TakeSweep();
  const auto valid = std::ranges::count_if(sweep.ranges, [](float range) { return std::isfinite(range); });
  const double share = static_cast<double>(valid) / static_cast<double>(sweep.ranges.size());
  if (share < options_.min_valid) {
    Fail("{} of {} beams have a distance, fewer than {:.0f} %; is the scanner covered, or in the sun?",
         valid, sweep.ranges.size(), 100.0 * options_.min_valid);
  }
  return fmt::format("{} of {} beams have a distance", valid, sweep.ranges.size());
}

std::string Preflight::FloorOf(drivers::HardwareRobot& robot) const {
  const slam::Scan scan = robot.TakeScan();
  const FloorSeen floor = SeeFloor(scan, robot_.mount);
  if (floor.points == 0)
    Fail("no floor is seen in {} slices; is hardware.mount right, and the floor before the robot free?",
         scan.sweeps.size());
  if (std::abs(floor.height) > options_.max_floor_height || floor.slope > options_.max_floor_slope) {
    Fail(
        "the floor lies {:.3f} m off and slopes by {:.3f}; the mount has been knocked, or the robot stands "
        "uneven: see hardware.mount, and run ariadne calibrate scanner",
        floor.height, floor.slope);
  }
  return fmt::format("{} slices; the floor is {:.0f} mm off, and slopes by {:.1f} mm/m", scan.sweeps.size(),
                     1000.0 * floor.height, 1000.0 * floor.slope);
}

/// The robot that the devices make. What fails first makes what follows senseless.
void Preflight::CheckWhole() {
  motors_.reset();
  drivers::HardwareRobot robot({Line(0), Line(1), Line(2)}, robot_);
  const bool swept = Try("test sweep", [&] {
    robot.Connect();
    return LevelSweep(robot);
  });
  if (!swept) return;
  Try("wheels", [&] {
    const drivers::Velocity velocity = robot.State().velocity;
    if (velocity.forward != 0.0 || velocity.turning != 0.0)
      Fail("the wheels turn though nobody told them to; switch the motors off");
    return std::string("stand still");
  });
  if (options_.scan) Try("test scan", [&] { return FloorOf(robot); });
}

}  // namespace

std::vector<PreflightItem> CheckRobot(const drivers::HardwareRobotOptions& robot,
                                      const PreflightOptions& options, const PreflightLines& lines,
                                      const PreflightSystem& system,
                                      const std::function<void(const std::string&)>& on_status) {
  CheckOptions(options, "check.");
  Preflight preflight(robot, options, on_status);
  preflight.CheckSystem(system);
  preflight.CheckMount();
  preflight.CheckDevices(lines);
  return std::move(preflight.items);
}

std::string ToText(const std::vector<PreflightItem>& items) {
  std::size_t width = 0;
  for (const PreflightItem& item : items) width = std::max(width, item.name.size());
  std::string text;
  for (const PreflightItem& item : items)
    text += fmt::format("{}  {:{}}  {}\n", item.ok ? "green" : "RED  ", item.name, width, item.text);
  return text;
}

}  // namespace ariadne::experiments
