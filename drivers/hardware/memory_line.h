#pragma once

#include <array>
#include <deque>
#include <memory>

#include "drivers/hardware/byte_stream.h"

namespace ariadne::drivers {

/// Two ends of a line in memory, with one clock that goes on only while an end waits. Bytes arrive at once;
/// those of an end with another rate than the reader's arrive as noise.
class MemoryLine {
 public:
  MemoryLine();

  /// End 0 or 1. Both must have gone before the line does.
  ByteStream& end(int which) { return *ends_[static_cast<std::size_t>(which)]; }

  /// Lets time pass [s].
  void Advance(double seconds) { now_ += seconds; }

  /// Cuts the line: both ends throw from now on.
  void Cut() { cut_ = true; }

 private:
  struct End;

  double now_ = 0.0;
  bool cut_ = false;
  std::array<std::unique_ptr<ByteStream>, 2> ends_;
};

}  // namespace ariadne::drivers
