#pragma once

#include <cstdint>
#include <vector>

#include "slam/base/random.h"

namespace ariadne::drivers {

/// Something that goes wrong on an emulated line.
struct LineFault {
  enum class Kind : std::uint8_t {
    kDrop,       // `count` bytes are lost
    kFlip,       // bit `bit` of each of `count` bytes is wrong
    kDuplicate,  // `count` bytes come twice
    kDelay,      // bytes are held for `duration`, and come in their order
    kDead,       // all bytes of both directions are lost for `duration`
    kPowerLoss,  // the device is without power for `duration`, and boots then
  };
  static constexpr int kKinds = 6;

  Kind kind = Kind::kDrop;
  double time = 0.0;       // from which on it waits for its first byte [s]
  bool to_device = false;  // else on the way to the host
  int count = 1;
  int bit = 0;
  double duration = 0.0;  // [s]
};

/// One fault of any kind at any time from `begin` to `end`. Power is lost in one of ten only, as it costs a
/// device a boot.
LineFault DrawFault(RandomStream& stream, double begin, double end);

}  // namespace ariadne::drivers
