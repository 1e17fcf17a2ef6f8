#pragma once

#include <memory>

#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/robot/emulated_robot.h"

namespace ariadne::drivers {

/// The three lines of an emulated robot in one virtual time, for a driver in the same program. They must
/// not outlive the robot; the robot must not take part in anything else.
struct EmulatedLines {
  std::unique_ptr<EmulatedLine> scanner;
  std::unique_ptr<EmulatedLine> servo;
  std::unique_ptr<EmulatedLine> motors;
};

EmulatedLines LinesTo(EmulatedRobot& robot);

}  // namespace ariadne::drivers
