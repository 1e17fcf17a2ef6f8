#include "drivers/emulated/line_fault.h"

namespace ariadne::drivers {

LineFault DrawFault(RandomStream& stream, double begin, double end) {
  LineFault fault;
  const bool power = stream() % 10 == 0;
  fault.kind = power ? LineFault::Kind::kPowerLoss
                     : static_cast<LineFault::Kind>(stream() % (LineFault::kKinds - 1));
  fault.time = DrawUniform(stream, begin, end);
  fault.to_device = stream() % 8 == 0;
  fault.count = 1 + static_cast<int>(stream() % 3);
  fault.bit = static_cast<int>(stream() % 8);
  fault.duration = DrawUniform(stream, 0.001, 0.3);
  if (fault.kind == LineFault::Kind::kFlip) fault.count = 1;  // what the device's checksum can tell
  return fault;
}

}  // namespace ariadne::drivers
