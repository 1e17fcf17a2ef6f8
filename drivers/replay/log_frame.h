#pragma once

#include <array>
#include <boost/crc.hpp>
#include <cstdint>
#include <cstring>
#include <string_view>

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

}  // namespace ariadne::drivers
