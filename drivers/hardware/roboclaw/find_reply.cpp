#include "drivers/hardware/roboclaw/find_reply.h"

#include <set>

#include "slam/base/error.h"

namespace ariadne::drivers::roboclaw {
namespace {

/// As DecodeReply, with acknowledgements.
std::optional<Bytes> DataOf(std::uint8_t address, Code code, ByteView reply) {
  if (!IsWrite(code)) return DecodeReply(address, code, reply);
  if (reply.empty()) return std::nullopt;
  if (reply.size() > 1 || reply[0] != kAcknowledged) Fail("this is no acknowledgement of the RoboClaw");
  return Bytes();
}

bool IsWhole(std::uint8_t address, Code code, ByteView reply) {
  try {
    return DataOf(address, code, reply).has_value();
  } catch (const Error&) {
    return false;
  }
}

/// Where answers that may have come before can end.
std::set<std::size_t> EndsOf(std::uint8_t address, ByteView bytes, std::span<const Code> late) {
  std::set<std::size_t> ends{0};
  for (const Code code : late) {
    if (code == Code::kVersion) continue;  // of no fixed length, and asked at the start only
    const std::size_t size = IsWrite(code) ? 1 : DataSize(code) + 2;
    const std::set<std::size_t> before = ends;
    for (const std::size_t end : before) {
      if (end + size <= bytes.size() && IsWhole(address, code, bytes.subspan(end, size)))
        ends.insert(end + size);
    }
  }
  return ends;
}

}  // namespace

FoundReply FindReply(std::uint8_t address, Code code, ByteView bytes, std::span<const Code> late) {
  FoundReply found{std::nullopt, false};
  for (const std::size_t end : EndsOf(address, bytes, late)) {
    try {
      found.data = DataOf(address, code, bytes.subspan(end));
    } catch (const Error&) {
      continue;  // it does not begin here
    }
    found.can_come = true;
    if (found.data) break;
  }
  // A late one of which not all is there.
  found.can_come = found.can_come || (!late.empty() && bytes.size() < kLongestVersion);
  return found;
}

}  // namespace ariadne::drivers::roboclaw
