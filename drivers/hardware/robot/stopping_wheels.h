#pragma once

#include "drivers/hardware/robot/hardware_robot.h"

namespace ariadne::drivers {

/// Calls, and where that throws, tells the motors to stop before anybody hears of it.
template <typename Call>
auto HardwareRobot::StoppingWheels(Call call) -> decltype(call()) {
  try {
    return call();
  } catch (...) {
    StopWheels();
    throw;
  }
}

}  // namespace ariadne::drivers
