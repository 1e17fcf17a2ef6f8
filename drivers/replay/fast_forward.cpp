#include "drivers/replay/fast_forward.h"

#include "drivers/replay/call_bytes.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

/// What the robot answers now, where that costs nothing; of other calls, only the effect.
RobotCall Repeated(SimulatedRobot& robot, RobotCall call) {
  if (auto* now = std::get_if<NowCall>(&call)) now->time = robot.Now();
  if (auto* mounting = std::get_if<MountingCall>(&call)) mounting->T_base_laser = robot.T_base_laser();
  if (auto* state = std::get_if<StateCall>(&call)) state->state = robot.State();
  if (auto* scan = std::get_if<ScanCall>(&call)) {
    robot.SkipScan();
    scan->scan.odometry = robot.State().odometry;
  }
  if (std::holds_alternative<SweepCall>(call)) robot.SkipSweep();
  if (std::holds_alternative<SafetySweepsCall>(call)) robot.SkipSafetySweeps();
  if (const auto* drive = std::get_if<DriveCall>(&call)) robot.Drive(drive->velocity);
  if (const auto* wait = std::get_if<WaitCall>(&call)) robot.WaitUntil(wait->until);
  return call;
}

}  // namespace

void FastForward(SimulatedRobot& robot, RobotLog& log) {
  for (std::size_t i = 0; i < log.size(); ++i) {
    const RobotCall recorded = log.Read(i);
    if (EncodeCall(Repeated(robot, recorded)) == EncodeCall(recorded)) continue;
    Fail(
        "{}: the simulated robot departs from the log at call {} ({:.3f} s), {}; go on with the world, the "
        "seed, the options and the version of the program that wrote the log",
        log.name(), i + 1, robot.Now(), Describe(recorded));
  }
}

}  // namespace ariadne::drivers
