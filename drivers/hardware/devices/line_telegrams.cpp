#include "drivers/hardware/devices/line_telegrams.h"

#include <algorithm>

namespace ariadne::drivers {

std::unique_ptr<TelegramReader> MakeTelegramReader(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::kLms200:
      return MakeLms200Reader();
    case DeviceKind::kDynamixel:
      return MakeDynamixelReader();
    case DeviceKind::kRoboclaw:
      return MakeRoboclawReader();
    case DeviceKind::kMaestro:
      return MakeMaestroReader();
  }
  Fail("there is no such device");
}

DeviceGuess::DeviceGuess() {
  for (const DeviceKind kind :
       {DeviceKind::kLms200, DeviceKind::kDynamixel, DeviceKind::kRoboclaw, DeviceKind::kMaestro}) {
    seen_.push_back({kind, 0, 0, 0});
    readers_.push_back(MakeTelegramReader(kind));
  }
}

void DeviceGuess::Take(const LineRecord& record) {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    for (const LineTelegram& telegram : readers_[i]->Take(record)) {
      if (telegram.to_device) {
        ++seen_[i].sent;
      } else {
        ++(telegram.bad ? seen_[i].bad : seen_[i].telegrams);
      }
    }
  }
}

/// Both sides count: where nobody answered, what was asked still tells.
DeviceGuess::Seen DeviceGuess::Best() const {
  return *std::max_element(seen_.begin(), seen_.end(), [](const Seen& a, const Seen& b) {
    return a.telegrams + a.sent < b.telegrams + b.sent;
  });
}

}  // namespace ariadne::drivers
