#include "drivers/emulated/robot/emulated_lines.h"

namespace ariadne::drivers {
namespace {

std::unique_ptr<EmulatedLine> LineTo(EmulatedDevice& device, std::string name,
                                     const std::shared_ptr<VirtualTime>& time) {
  EmulatedLineOptions options;
  options.name = std::move(name);
  options.time = time;
  return std::make_unique<EmulatedLine>(device, options);
}

}  // namespace

EmulatedLines LinesTo(EmulatedRobot& robot) {
  const auto time = std::make_shared<VirtualTime>();
  EmulatedLines lines{LineTo(robot.scanner(), "the emulated scanner's line", time),
                      LineTo(robot.mount(), "the emulated servo's line", time),
                      LineTo(robot.motors(), "the emulated motors' line", time)};
  // The driver reads the scanner's line only while the other two live.
  robot.SetCatchUp([servo = lines.servo.get(), motors = lines.motors.get()](double until) {
    servo->CatchUp(until);
    motors->CatchUp(until);
  });
  return lines;
}

}  // namespace ariadne::drivers
