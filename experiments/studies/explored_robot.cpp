#include "experiments/studies/explored_robot.h"

#include <utility>

#include "drivers/emulated/robot/emulated_lines.h"
#include "drivers/replay/fast_forward.h"
#include "experiments/studies/run_notes.h"

namespace ariadne::experiments {
namespace {

// The lines by their numbers in the log.
constexpr std::uint8_t kScannerLine = 0;
constexpr std::uint8_t kServoLine = 1;
constexpr std::uint8_t kMotorsLine = 2;

std::unique_ptr<drivers::ByteStream> RecordedLine(std::unique_ptr<drivers::ByteStream> line,
                                                  std::uint8_t number, drivers::LineLogWriter& log) {
  return std::make_unique<drivers::RecordingStream>(
      std::move(line), [number, &log](const drivers::LineRecord& record) { log.Add(number, record); });
}

drivers::RobotLines RecordedLines(drivers::RobotLines lines, drivers::LineLogWriter* to) {
  if (to == nullptr) return lines;
  drivers::LineLogWriter& log = *to;
  return {RecordedLine(std::move(lines.scanner), kScannerLine, log),
          RecordedLine(std::move(lines.servo), kServoLine, log),
          RecordedLine(std::move(lines.motors), kMotorsLine, log)};
}

class Simulated : public ExploredRobot {
 public:
  Simulated(std::shared_ptr<const drivers::RayScene> scene, const drivers::SimulatedRobotOptions& options,
            std::uint64_t seed)
      : robot_(std::move(scene), options, seed) {}

  drivers::Robot& robot() override { return robot_; }
  const drivers::SimulatedBase* truth() const override { return &robot_.base(); }
  drivers::Seam Resume(drivers::RobotLog& log) override {
    drivers::FastForward(robot_, log);
    return drivers::Seam::kNone;
  }

 private:
  drivers::SimulatedRobot robot_;
};

/// A run that is resumed begins its log of the lines anew, and the robot all that it did.
std::filesystem::path LogOfLinesAnew(const RunDirectory& run) {
  std::filesystem::path path = run.File(kLineLog);
  for (int number = 0; std::filesystem::remove(drivers::LineLogFile(path, number)); ++number) {
  }
  return path;
}

/// The mount that the drivers are for.
drivers::EmulatedRobotOptions WithServoOf(drivers::EmulatedRobotOptions emulated,
                                          const drivers::HardwareRobotOptions& hardware) {
  emulated.servo_kind = hardware.servo_kind;
  return emulated;
}

class Emulated : public ExploredRobot {
 public:
  Emulated(std::shared_ptr<const drivers::RayScene> scene, const drivers::SimulatedRobotOptions& robot,
           const drivers::HardwareRobotOptions& hardware, const drivers::EmulatedRobotOptions& emulated,
           std::uint64_t seed, const RunDirectory* run)
      : log_(run == nullptr ? nullptr : std::make_unique<drivers::LineLogWriter>(LogOfLinesAnew(*run))),
        devices_(std::move(scene), robot.base, robot.ais, WithServoOf(emulated, hardware), seed),
        robot_(Lines(), hardware) {
    robot_.Connect();
  }

  drivers::Robot& robot() override { return robot_; }
  const drivers::SimulatedBase* truth() const override { return &devices_.base(); }
  drivers::Seam Resume(drivers::RobotLog& log) override {
    drivers::RepeatAll(robot_, log);
    return drivers::Seam::kNone;
  }
  void Note(const std::string& text) override {
    if (log_) log_->Note(text);
  }

 private:
  drivers::RobotLines Lines() {
    drivers::EmulatedLines lines = drivers::LinesTo(devices_);
    return RecordedLines({std::move(lines.scanner), std::move(lines.servo), std::move(lines.motors)},
                         log_.get());
  }

  std::unique_ptr<drivers::LineLogWriter> log_;
  drivers::EmulatedRobot devices_;
  drivers::HardwareRobot robot_;
};

/// Each start of a run that is resumed has a log of its own: lines.log, lines-2.log ...
std::filesystem::path NextLogOfLines(const RunDirectory& run) {
  std::filesystem::path path = run.File(kLineLog);
  for (int start = 2; std::filesystem::exists(drivers::LineLogFile(path, 0)); ++start)
    path = run.File("lines-" + std::to_string(start) + ".log");
  return path;
}

/// The drivers on lines of any kind, and a log of them, if any.
class Real : public ExploredRobot {
 public:
  Real(std::unique_ptr<drivers::LineLogWriter> log, drivers::RobotLines lines,
       const drivers::HardwareRobotOptions& options, const drivers::GuardOptions& guard,
       std::function<bool()> stop)
      : log_(std::move(log)),
        robot_(RecordedLines(std::move(lines), log_.get()), options),
        stop_([stop = std::move(stop)] {
          return stop && stop() ? std::string("it was told to stop") : std::string();
        }),
        guarded_(robot_, stop_, guard) {
    robot_.Connect();
  }

  drivers::Robot& robot() override { return guarded_; }
  drivers::Robot& unguarded() { return robot_; }
  const drivers::SimulatedBase* truth() const override { return nullptr; }
  drivers::Seam Resume(drivers::RobotLog& log) override {
    Note(ResumedNote(log.size()));
    return drivers::Seam::kRestarted;
  }
  void Note(const std::string& text) override {
    if (log_) log_->Note(text);
  }

 private:
  std::unique_ptr<drivers::LineLogWriter> log_;
  drivers::HardwareRobot robot_;
  drivers::EmergencyStop stop_;
  drivers::GuardedRobot guarded_;
};

/// What was recorded of an emulated robot, or of a real one, which is guarded.
class Replayed : public Real {
 public:
  Replayed(drivers::RobotLines lines, const ExploringRobotOptions& robot,
           const drivers::HardwareRobotOptions& options, const std::function<bool()>& stop)
      : Real(nullptr, std::move(lines), options, robot.guard, stop),
        guarded_(robot.kind == RobotKind::kHardware) {}

  drivers::Robot& robot() override { return guarded_ ? Real::robot() : unguarded(); }

 private:
  bool guarded_;
};

}  // namespace

drivers::HardwareRobotOptions MissionHardwareOptions() {
  drivers::HardwareRobotOptions options;
  options.scanner.resolution = 1.0;
  return options;
}

std::unique_ptr<ExploredRobot> MakeExploredRobot(const ExploringRobotOptions& robot,
                                                 const drivers::HardwareRobotOptions& hardware,
                                                 const drivers::EmulatedRobotOptions& emulated,
                                                 std::shared_ptr<const drivers::RayScene> scene,
                                                 std::uint64_t seed, const RunDirectory* run,
                                                 const std::function<bool()>& stop) {
  switch (robot.kind) {
    case RobotKind::kSimulated:
      return std::make_unique<Simulated>(std::move(scene), robot, seed);
    case RobotKind::kEmulated:
      return std::make_unique<Emulated>(std::move(scene), robot, hardware, emulated, seed, run);
    case RobotKind::kHardware:
      break;
  }
  std::unique_ptr<drivers::LineLogWriter> log;
  if (run != nullptr) log = std::make_unique<drivers::LineLogWriter>(NextLogOfLines(*run));
  return std::make_unique<Real>(std::move(log), drivers::OpenPorts(hardware), hardware, robot.guard, stop);
}

std::unique_ptr<ExploredRobot> MakeReplayedRobot(const ExploringRobotOptions& robot,
                                                 const drivers::HardwareRobotOptions& hardware,
                                                 drivers::RecordedLines& lines,
                                                 const std::function<bool()>& stop) {
  drivers::RobotLines opened{lines.Open(kScannerLine), lines.Open(kServoLine), lines.Open(kMotorsLine)};
  return std::make_unique<Replayed>(std::move(opened), robot, hardware, stop);
}

}  // namespace ariadne::experiments
