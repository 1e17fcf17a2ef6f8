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

  double Now() const override;
  slam::Pose3 T_base_laser() const override;
  slam::Scan TakeScan() override;
  slam::LaserSweep TakeSweep() override;
  std::vector<SafetySweep> TakeSafetySweeps() override;
  RobotState State() override;
  void Drive(const Velocity& velocity) override;
  void WaitUntil(double time) override;
  void Note(std::string_view text) override;

 private:
  template <typename Call>
  Call Recorded(Call call) const;

  Robot& robot_;
  RobotLogWriter& log_;
};

}  // namespace ariadne::drivers
