#pragma once

#include <optional>
#include <span>

#include "drivers/hardware/roboclaw/packet.h"

namespace ariadne::drivers::roboclaw {

struct FoundReply {
  std::optional<Bytes> data;  // of the reply; empty for an acknowledgement
  bool can_come = true;       // more bytes could make one of what is there
};

/// The reply to `code` at the end of bytes that answers to earlier requests may precede, each of them, in
/// their order, or not: replies have no beginning, and come late where something held them back.
FoundReply FindReply(std::uint8_t address, Code code, ByteView bytes, std::span<const Code> late);

}  // namespace ariadne::drivers::roboclaw
