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

void RecordingRobot::Record(const RobotCall& call) const {
  try {
    log_.Append(call);
  } catch (const Error&) {
    StopWheels(robot_);
    throw;
  }
}

RobotCall RecordingRobot::Answer(RobotCall asked) const {
  RobotCall made = MadeCall(robot_, std::move(asked));
  Record(made);
  return made;
}

void RecordingRobot::Note(std::string_view text) { Record(drivers::Note{std::string(text)}); }

}  // namespace ariadne::drivers
