#pragma once

#include <vector>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers {

/// Bytes that a device sends in one go.
struct Sending {
  double start = 0.0;      // of the first bit [s]
  double byte_time = 0.0;  // from one byte to the next [s]; 0 for a device that is not paced
  int baud = 9600;
  Bytes bytes;
};

/// The device's side of a line. It is told the time and never looks at a clock, so that it may live in
/// virtual time or on a pseudo-terminal. Times never go back.
class EmulatedDevice {
 public:
  virtual ~EmulatedDevice() = default;

  /// Bytes whose last one arrives at `time` [s], sent with `baud`. Advance(time) comes before.
  virtual void Receive(ByteView bytes, int baud, double time) = 0;

  /// When it next does something by itself [s]; infinity for never.
  virtual double NextTime() const = 0;

  /// Does all that is due until `time`, and returns what it began to send since the last call.
  virtual std::vector<Sending> Advance(double time) = 0;

  /// Loses its power at `time` and has it again `seconds` later.
  virtual void LosePower(double time, double seconds) = 0;
};

}  // namespace ariadne::drivers
