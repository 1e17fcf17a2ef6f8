#pragma once

#include "drivers/replay/logged_robot.h"
#include "drivers/replay/robot_log.h"

namespace ariadne::drivers {

/// Another robot, with a log: each answer is on the log before it is returned. Where the log cannot be
/// written, the wheels are told to stop, and the call throws the log's Error.
class RecordingRobot : public LoggedRobot {
 public:
  /// Keeps references.
  RecordingRobot(Robot& robot, RobotLogWriter& log) : robot_(robot), log_(log) {}

  void Note(std::string_view text) override;

 private:
  RobotCall Answer(RobotCall asked) const override;
  void Record(const RobotCall& call) const;

  Robot& robot_;
  RobotLogWriter& log_;
};

}  // namespace ariadne::drivers
