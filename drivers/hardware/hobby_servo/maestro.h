#pragma once

#include <cstdint>
#include <optional>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers::hobby_servo {

/// Commands of the compact protocol of Pololu's Maestro servo controllers (their user's guide, section
/// 5.e). Bytes of commands have the highest bit set and those of data do not, so that a controller finds
/// the next command after whatever went wrong. There is no checksum (the optional one guards commands only,
/// and replies never have one), and nothing tells where a servo really is: the position is the pulse that
/// the controller sends at this moment.
enum class Code : std::uint8_t {
  kSetTarget = 0x84,        // channel, 14 bits of 0.25 us; 0 sends no pulses
  kSetSpeed = 0x87,         // channel, 14 bits of 0.25 us per 10 ms; 0 for no limit
  kSetAcceleration = 0x89,  // channel, 14 bits of 0.25 us per 10 ms per 80 ms, to 255; 0 for no limit
  kPosition = 0x90,         // channel; replies with 16 bits of 0.25 us
  kErrors = 0xA1,           // replies with 16 bits, and clears them
  kDetectBaud = 0xAA,       // the first byte where the controller is to find its rate
};

// Units.
constexpr double kPulseUnit = 0.25e-6;                            // [s]
constexpr double kSpeedUnit = kPulseUnit / 0.010;                 // [s of pulse per s]
constexpr double kAccelerationUnit = kPulseUnit / 0.010 / 0.080;  // [s of pulse per s^2]
constexpr int kLargestNumber = 0x3FFF;

/// Bits of kErrors.
constexpr std::uint16_t kSerialErrors = 0x001F;  // signal, overrun, full, checksum, protocol
constexpr std::uint16_t kTimeoutError = 0x0020;
constexpr std::uint16_t kScriptErrors = 0x01C0;

struct Request {
  Code code = Code::kErrors;
  std::uint8_t channel = 0;
  int number = 0;  // of the three commands that set

  bool operator==(const Request&) const = default;
};

/// How many bytes of data a command has: channel and number.
std::size_t DataSize(Code code);
bool IsCode(std::uint8_t byte);

/// Error for a channel above 23, or a number of more than 14 bits.
Bytes EncodeRequest(const Request& request);

/// The number of a reply, the lower byte first.
std::uint16_t NumberOf(ByteView reply);

/// Finds requests in what a controller receives.
class RequestDecoder {
 public:
  void Push(ByteView bytes) { buffer_.insert(buffer_.end(), bytes.begin(), bytes.end()); }

  /// The next one; none until more bytes come. What is none is counted and passed over.
  std::optional<Request> Next();
  std::uint64_t bad() const { return bad_; }

 private:
  Bytes buffer_;
  std::uint64_t bad_ = 0;
};

}  // namespace ariadne::drivers::hobby_servo
