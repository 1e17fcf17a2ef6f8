#pragma once

#include <string>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers {

/// One end of a line to a device: a serial port, an emulated device, or a recording. It has a clock of its
/// own, and whoever talks over it looks at no other, so that a test, an emulation or a replay decides how
/// time passes. Each call throws an Error with the name of the line when the line is gone.
class ByteStream {
 public:
  virtual ~ByteStream() = default;

  /// For messages: the path of a port.
  virtual std::string name() const = 0;

  /// Seconds; monotonic.
  virtual double Now() const = 0;

  /// What has arrived; waits until there is something, but not longer than to `deadline` [s], after which
  /// the result is empty. A deadline in the past takes what is there.
  virtual Bytes Read(double deadline) = 0;

  /// Sends all bytes; may return before they have left.
  virtual void Write(ByteView bytes) = 0;

  /// Changes the rate [baud] of this end, after what was written has left, and forgets what has arrived.
  virtual void SetBaud(int baud) = 0;
  virtual int baud() const = 0;
};

/// Reads and forgets until `time`.
inline void DiscardUntil(ByteStream& stream, double time) {
  while (stream.Now() < time) stream.Read(time);
}

}  // namespace ariadne::drivers
