#include "drivers/hardware/roboclaw/packet.h"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>

namespace ariadne::drivers::roboclaw {
namespace {

constexpr std::array<Code, 11> kRoboclawCodes{Code::kSetTimeout,
                                              Code::kTimeout,
                                              Code::kResetEncoders,
                                              Code::kVersion,
                                              Code::kBattery,
                                              Code::kSpeeds,
                                              Code::kSpeedsWithAcceleration,
                                              Code::kCurrents,
                                              Code::kEncoders,
                                              Code::kMeasuredSpeeds,
                                              Code::kStatus};

using CrcOfPackets = boost::crc_optimal<16, 0x1021, 0, 0, false, false>;

/// That of a reply covers its request.
std::uint16_t CrcOfReply(std::uint8_t address, Code code, ByteView data) {
  CrcOfPackets crc;
  crc.process_byte(address);
  crc.process_byte(static_cast<std::uint8_t>(code));
  crc.process_bytes(data.data(), data.size());
  return static_cast<std::uint16_t>(crc.checksum());
}

/// How many bytes of a version there are up to its zero; 0 while that has not come.
std::size_t VersionSize(ByteView reply) {
  const auto zero = std::find(reply.begin(), reply.end(), std::uint8_t{0});
  if (zero == reply.end()) return 0;
  return static_cast<std::size_t>(zero - reply.begin()) + 1;
}

}  // namespace

std::uint16_t Crc(ByteView bytes) {
  CrcOfPackets crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return static_cast<std::uint16_t>(crc.checksum());
}

bool IsWrite(Code code) {
  return code == Code::kSetTimeout || code == Code::kResetEncoders || code == Code::kSpeeds ||
         code == Code::kSpeedsWithAcceleration;
}

std::size_t DataSize(Code code) {
  switch (code) {
    case Code::kSetTimeout:
    case Code::kTimeout:
      return 1;
    case Code::kBattery:
    case Code::kStatus:
      return 2;
    case Code::kCurrents:
      return 4;
    case Code::kSpeeds:
    case Code::kEncoders:
    case Code::kMeasuredSpeeds:
      return 8;
    case Code::kSpeedsWithAcceleration:
      return 12;
    default:
      return 0;
  }
}

void PutNumber(Bytes& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t i = size; i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFF));
}

std::uint32_t NumberAt(ByteView bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[at + i];
  return value;
}

Bytes EncodeRequest(std::uint8_t address, Code code, const Bytes& data) {
  const bool write = IsWrite(code);
  if (write && data.size() != DataSize(code)) {
    Fail("command {} of the RoboClaw carries {} bytes, not {}", static_cast<int>(code), DataSize(code),
         data.size());
  }
  WireWriter writer;
  writer.Byte(address);
  writer.Byte(static_cast<std::uint8_t>(code));
  if (write) writer.Rest(data);
  Bytes bytes = writer.Finish();
  if (write) PutNumber(bytes, Crc(bytes), 2);
  return bytes;
}

Bytes EncodeReply(std::uint8_t address, Code code, const Bytes& data) {
  if (IsWrite(code)) return {kAcknowledged};
  Bytes reply = data;
  PutNumber(reply, CrcOfReply(address, code, data), 2);
  return reply;
}

std::optional<Bytes> DecodeReply(std::uint8_t address, Code code, ByteView reply) {
  std::size_t size = DataSize(code);
  if (code == Code::kVersion) {
    size = VersionSize(reply);
    if (size > kLongestVersion || (size == 0 && reply.size() >= kLongestVersion)) {
      Fail("the RoboClaw's version has no end");
    }
    if (size == 0) return std::nullopt;
  }
  if (reply.size() < size + 2) return std::nullopt;
  if (reply.size() > size + 2)
    Fail("a reply of the RoboClaw has {} bytes too many", reply.size() - size - 2);
  if (CrcOfReply(address, code, reply.first(size)) != NumberAt(reply, size, 2)) {
    Fail("a reply of the RoboClaw has a wrong checksum");
  }
  return Bytes(reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(size));
}

std::optional<Request> RequestDecoder::Next() {
  while (!buffer_.empty()) {
    if (buffer_[0] == address_) {
      if (buffer_.size() < 2) return std::nullopt;
      const auto code = static_cast<Code>(buffer_[1]);
      const bool known =
          std::find(kRoboclawCodes.begin(), kRoboclawCodes.end(), code) != kRoboclawCodes.end();
      const std::size_t size = known && IsWrite(code) ? 2 + DataSize(code) + 2 : 2;
      if (known && buffer_.size() < size) return std::nullopt;
      const bool right = known && (!IsWrite(code) || Crc(ByteView(buffer_).first(size - 2)) ==
                                                         NumberAt(buffer_, size - 2, 2));
      if (right) {
        Request request{code, {}};
        if (IsWrite(code)) {
          request.data.assign(buffer_.begin() + 2, buffer_.begin() + static_cast<std::ptrdiff_t>(size - 2));
        }
        buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size));
        return request;
      }
    }
    buffer_.erase(buffer_.begin());
  }
  return std::nullopt;
}

}  // namespace ariadne::drivers::roboclaw
