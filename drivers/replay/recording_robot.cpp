#include "drivers/replay/recording_robot.h"

#include <utility>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

void StopWheels(Robot& robot) {
  try {
    robot.Drive({});
  } catch (const Error&) {
    // What is wrong with the log is what the user is told.
  }
}

}  // namespace

template <typename Call>
Call RecordingRobot::Recorded(Call call) const {
  RobotCall record = std::move(call);
  try {
    log_.Append(record);
  } catch (const Error&) {
    StopWheels(robot_);
    throw;
  }
  return std::get<Call>(std::move(record));
}

double RecordingRobot::Now() const { return Recorded(NowCall{robot_.Now()}).time; }

slam::Pose3 RecordingRobot::T_base_laser() const {
  return Recorded(MountingCall{robot_.T_base_laser()}).T_base_laser;
}

slam::Scan RecordingRobot::TakeScan() { return Recorded(ScanCall{robot_.TakeScan()}).scan; }

slam::LaserSweep RecordingRobot::TakeSweep() { return Recorded(SweepCall{robot_.TakeSweep()}).sweep; }

std::vector<SafetySweep> RecordingRobot::TakeSafetySweeps() {
  return Recorded(SafetySweepsCall{robot_.TakeSafetySweeps()}).sweeps;
}

RobotState RecordingRobot::State() { return Recorded(StateCall{robot_.State()}).state; }

void RecordingRobot::Drive(const Velocity& velocity) {
  robot_.Drive(velocity);
  Recorded(DriveCall{velocity});
}

void RecordingRobot::WaitUntil(double time) {
  robot_.WaitUntil(time);
  Recorded(WaitCall{time});
}

void RecordingRobot::Note(std::string_view text) { Recorded(drivers::Note{std::string(text)}); }

}  // namespace ariadne::drivers
