#pragma once

#include <boost/crc.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/replay/call_bytes.h"

namespace ariadne::drivers {

/// What a log begins with.
constexpr std::string_view kRobotLogMagic = "ARIADLOG";
constexpr std::uint32_t kRobotLogVersion = 1;
constexpr std::size_t kRobotLogHeadSize = 12;  // [B]

/// What stands before the payload of a record.
struct FrameHead {
  std::uint32_t length = 0;  // of the payload [B]
  std::uint32_t crc = 0;
};
static_assert(sizeof(FrameHead) == 8);

/// The checksum of a record. It covers the length too: else the zeros that a file system may leave at the
/// end of a file would be empty records.
inline std::uint32_t FrameCrc(std::uint32_t length, std::string_view payload) {
  boost::crc_32_type crc;
  crc.process_bytes(&length, sizeof length);
  crc.process_bytes(payload.data(), payload.size());
  return crc.checksum();
}

/// After which records the writer waits for the disk.
inline bool IsSafeAtOnce(CallKind kind) { return kind == CallKind::kScan || kind == CallKind::kNote; }

/// The bytes with which a file begins.
inline std::string HeadOfLog() {
  std::string head(kRobotLogMagic);
  head.append(reinterpret_cast<const char*>(&kRobotLogVersion), sizeof kRobotLogVersion);
  return head;
}

/// A record with its frame.
inline std::string FramedCall(const RobotCall& call) {
  const std::string payload = EncodeCall(call);
  FrameHead head;
  head.length = static_cast<std::uint32_t>(payload.size());
  head.crc = FrameCrc(head.length, payload);
  return std::string(reinterpret_cast<const char*>(&head), sizeof head) + payload;
}

}  // namespace ariadne::drivers
