#include "drivers/replay/fast_forward.h"

#include <array>
#include <cstdint>

#include "drivers/replay/call_bytes.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

constexpr int kMeasuredAgain = 32;  // one in so many; others are skipped

/// Repeats calls on a simulated robot.
class Repeater {
 public:
  explicit Repeater(SimulatedRobot& robot) : robot_(robot) {}

  /// What the robot answers now; skipped measurements are those of the log.
  RobotCall Repeated(RobotCall call) {
    const int earlier = counts_[call.index()]++;
    const bool measure = earlier % kMeasuredAgain == 0;
    if (auto* now = std::get_if<NowCall>(&call)) now->time = robot_.Now();
    if (auto* mounting = std::get_if<MountingCall>(&call)) mounting->T_base_laser = robot_.T_base_laser();
    if (auto* state = std::get_if<StateCall>(&call)) state->state = robot_.State();
    if (auto* scan = std::get_if<ScanCall>(&call)) RepeatScan(*scan, measure);
    if (auto* sweep = std::get_if<SweepCall>(&call)) RepeatSweep(*sweep, measure);
    if (auto* safety = std::get_if<SafetySweepsCall>(&call)) RepeatSafetySweeps(*safety, measure);
    if (const auto* drive = std::get_if<DriveCall>(&call)) robot_.Drive(drive->velocity);
    if (const auto* wait = std::get_if<WaitCall>(&call)) robot_.WaitUntil(wait->until);
    return call;
  }

 private:
  void RepeatScan(ScanCall& call, bool measure) {
    if (measure) {
      call.scan = robot_.TakeScan();
    } else {
      robot_.SkipScan();
      call.scan.odometry = robot_.State().odometry;
    }
  }
  void RepeatSweep(SweepCall& call, bool measure) {
    measure ? void(call.sweep = robot_.TakeSweep()) : robot_.SkipSweep();
  }
  void RepeatSafetySweeps(SafetySweepsCall& call, bool measure) {
    measure ? void(call.sweeps = robot_.TakeSafetySweeps()) : robot_.SkipSafetySweeps();
  }

  SimulatedRobot& robot_;
  std::array<int, std::variant_size_v<RobotCall>> counts_{};
};

/// One that takes all of its measurements again.
RobotCall Again(Robot& robot, RobotCall call) {
  if (auto* now = std::get_if<NowCall>(&call)) now->time = robot.Now();
  if (auto* mounting = std::get_if<MountingCall>(&call)) mounting->T_base_laser = robot.T_base_laser();
  if (auto* state = std::get_if<StateCall>(&call)) state->state = robot.State();
  if (auto* scan = std::get_if<ScanCall>(&call)) scan->scan = robot.TakeScan();
  if (auto* sweep = std::get_if<SweepCall>(&call)) sweep->sweep = robot.TakeSweep();
  if (auto* safety = std::get_if<SafetySweepsCall>(&call)) safety->sweeps = robot.TakeSafetySweeps();
  if (const auto* drive = std::get_if<DriveCall>(&call)) robot.Drive(drive->velocity);
  if (const auto* wait = std::get_if<WaitCall>(&call)) robot.WaitUntil(wait->until);
  return call;
}

void RequireTheSame(const RobotCall& again, const RobotCall& recorded, const RobotLog& log, std::size_t i,
                    const Robot& robot) {
  if (EncodeCall(again) == EncodeCall(recorded)) return;
  Fail(
      "{}: the simulated robot departs from the log at call {} ({:.3f} s), {}; go on with the world, the "
      "seed, the options and the version of the program that wrote the log",
      log.name(), i + 1, robot.Now(), Describe(recorded));
}

}  // namespace

void FastForward(SimulatedRobot& robot, RobotLog& log) {
  Repeater repeater(robot);
  for (std::size_t i = 0; i < log.size(); ++i) {
    const RobotCall recorded = log.Read(i);
    RequireTheSame(repeater.Repeated(recorded), recorded, log, i, robot);
  }
}

void RepeatAll(Robot& robot, RobotLog& log) {
  for (std::size_t i = 0; i < log.size(); ++i) {
    const RobotCall recorded = log.Read(i);
    const RobotCall again = Again(robot, recorded);
    RequireTheSame(again, recorded, log, i, robot);
  }
}

}  // namespace ariadne::drivers
