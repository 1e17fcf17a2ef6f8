#pragma once

#include <string_view>

#include "drivers/robot.h"

namespace ariadne::drivers {

/// A robot whose calls and answers are on a log: what a mission drives that can be resumed. The mission
/// must be a function of the answers alone, and after an Error it must end, without further calls: calls
/// that failed are not on the log, so that a resumed mission asks the robot once more.
class LoggedRobot : public Robot {
 public:
  /// Puts a line on the log, and all before it, safely on the disk: a decision, a reason.
  virtual void Note(std::string_view text) = 0;
};

}  // namespace ariadne::drivers
