#pragma once

#include "drivers/replay/log_cursor.h"
#include "drivers/replay/logged_robot.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

/// A call that the log does not have at its place, or an answer that is another one there.
class DepartedFromLog : public Error {
 public:
  using Error::Error;
};

/// Another robot whose calls, answers and notes are compared with those of a log, bit by bit, as long as
/// this lasts: a call before it is made, so that nothing is done that was not done. Where they differ it
/// throws a DepartedFromLog that says what the log has.
class ComparedRobot : public LoggedRobot {
 public:
  /// Keeps references.
  ComparedRobot(Robot& robot, RobotLog& log) : robot_(robot), cursor_(log) {}

  void Note(std::string_view text) override;

  /// Records of the log that were found again.
  std::size_t compared() const { return cursor_.position(); }
  std::size_t left() const { return cursor_.left(); }

 private:
  RobotCall Answer(RobotCall asked) const override;
  [[noreturn]] void FailDiffering(const RobotCall& recorded, const std::string& now) const;

  Robot& robot_;
  mutable LogCursor cursor_;
};

}  // namespace ariadne::drivers
