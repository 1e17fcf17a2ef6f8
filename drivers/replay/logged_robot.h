#pragma once

#include <string_view>

#include "drivers/replay/robot_call.h"

namespace ariadne::drivers {

/// A robot whose calls and answers are on a log: what a mission drives that can be resumed. The mission
/// must be a function of the answers alone, and after an Error it must end, without further calls: calls
/// that failed are not on the log, so that a resumed mission asks the robot once more.
class LoggedRobot : public Robot {
 public:
  double Now() const final;
  slam::Pose3 T_base_laser() const final;
  slam::Scan TakeScan() final;
  slam::LaserSweep TakeSweep() final;
  std::vector<SafetySweep> TakeSafetySweeps() final;
  RobotState State() final;
  void Drive(const Velocity& velocity) final;
  void WaitUntil(double time) final;

  /// Puts a line on the log, and all before it, safely on the disk: a decision, a reason.
  virtual void Note(std::string_view text) = 0;

 private:
  template <typename Call>
  Call Answered(Call asked) const;

  /// The same call with its answer. Const for those that are; the others change the robot and its log,
  /// which are elsewhere.
  virtual RobotCall Answer(RobotCall asked) const = 0;
};

/// Makes a call, which is no Note, and returns it with the robot's answer.
RobotCall MadeCall(Robot& robot, RobotCall asked);

}  // namespace ariadne::drivers
