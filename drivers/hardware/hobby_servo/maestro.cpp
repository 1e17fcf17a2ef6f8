#include "drivers/hardware/hobby_servo/maestro.h"

#include <algorithm>

namespace ariadne::drivers::hobby_servo {
namespace {

constexpr std::uint8_t kMostChannels = 24;
constexpr std::uint8_t kCommandBit = 0x80;

bool Sets(Code code) {
  return code == Code::kSetTarget || code == Code::kSetSpeed || code == Code::kSetAcceleration;
}

}  // namespace

std::size_t DataSize(Code code) {
  if (Sets(code)) return 3;
  return code == Code::kPosition ? 1 : 0;
}

bool IsCode(std::uint8_t byte) {
  const auto code = static_cast<Code>(byte);
  return Sets(code) || code == Code::kPosition || code == Code::kErrors || code == Code::kDetectBaud;
}

Bytes EncodeRequest(const Request& request) {
  if (request.channel >= kMostChannels)
    Fail("a servo controller has channels 0 to 23, not {}", request.channel);
  if (request.number < 0 || request.number > kLargestNumber)
    Fail("a servo controller takes numbers up to {}, not {}", kLargestNumber, request.number);
  Bytes bytes = {static_cast<std::uint8_t>(request.code)};
  if (DataSize(request.code) >= 1) bytes.push_back(request.channel);
  if (DataSize(request.code) == 3) {
    bytes.push_back(static_cast<std::uint8_t>(request.number & 0x7F));
    bytes.push_back(static_cast<std::uint8_t>(request.number >> 7));
  }
  return bytes;
}

std::uint16_t NumberOf(ByteView reply) { return static_cast<std::uint16_t>(reply[0] | reply[1] << 8); }

std::optional<Request> RequestDecoder::Next() {
  while (!buffer_.empty()) {
    const auto code = static_cast<Code>(buffer_[0]);
    const std::size_t size = IsCode(buffer_[0]) ? 1 + DataSize(code) : 0;
    const auto last = buffer_.begin() + static_cast<std::ptrdiff_t>(std::min(size, buffer_.size()));
    const auto broken = size == 0 ? buffer_.begin()
                                  : std::find_if(buffer_.begin() + 1, last,
                                                 [](std::uint8_t b) { return (b & kCommandBit) != 0; });
    const bool valid = size > 0 && broken == last;
    if (valid && buffer_.size() < size) return std::nullopt;
    Request request{code, 0, 0};
    if (valid && size > 1) request.channel = buffer_[1];
    if (valid && size == 4) request.number = buffer_[2] | buffer_[3] << 7;
    if (valid && request.channel < kMostChannels) {
      buffer_.erase(buffer_.begin(), last);
      return request;
    }
    ++bad_;
    buffer_.erase(buffer_.begin());
  }
  return std::nullopt;
}

}  // namespace ariadne::drivers::hobby_servo
