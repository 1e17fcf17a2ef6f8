#pragma once

#include <cstdint>
#include <optional>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers::roboclaw {

/// Commands of packet serial (spec, section 10, and the manufacturer's manual).
enum class Code : std::uint8_t {
  kSetTimeout = 14,  // [100 ms]; the motors stop when nothing valid has come for so long; 0 for never
  kTimeout = 15,
  kResetEncoders = 20,
  kVersion = 21,
  kBattery = 24,  // [0.1 V]
  kSpeeds = 37,   // of both motors [pulses/s]
  kSpeedsWithAcceleration = 40,
  kCurrents = 49,  // [10 mA], signed
  kEncoders = 78,
  kMeasuredSpeeds = 79,
  kStatus = 90,
};

constexpr std::uint8_t kAcknowledged = 0xFF;
constexpr std::size_t kLongestVersion = 48;  // [B], with its line feed and zero
constexpr double kPacketPause = 0.01;        // after which the device forgets half a packet [s]

/// CRC-16 with polynomial 0x1021 from 0, highest bit first.
std::uint16_t Crc(ByteView bytes);

/// Whether the command changes something: it carries data and a checksum and gets one byte, 0xFF. The
/// others are sent without checksum, as the manual says, and get data and a checksum over request and data.
bool IsWrite(Code code);

/// How many bytes of data a write carries, or the reply to a read; the version is as long as it is.
std::size_t DataSize(Code code);

Bytes EncodeRequest(std::uint8_t address, Code code, const Bytes& data = {});
Bytes EncodeReply(std::uint8_t address, Code code, const Bytes& data);

/// The data of a reply to a read, none as long as bytes are missing. Error if the checksum is wrong, or
/// there are more bytes.
std::optional<Bytes> DecodeReply(std::uint8_t address, Code code, ByteView reply);

// Numbers are sent with the highest byte first.
void PutNumber(Bytes& bytes, std::uint32_t value, std::size_t size);
std::uint32_t NumberAt(ByteView bytes, std::size_t at, std::size_t size);

/// A packet as the device receives it.
struct Request {
  Code code = Code::kStatus;
  Bytes data;
};

/// Takes requests to one address from a stream of bytes. The device has no mark for the beginning of a
/// packet: what does not begin with its address, has an unknown command or a wrong checksum is passed over.
class RequestDecoder {
 public:
  explicit RequestDecoder(std::uint8_t address) : address_(address) {}

  void Push(ByteView bytes) { buffer_.insert(buffer_.end(), bytes.begin(), bytes.end()); }
  std::optional<Request> Next();
  void Forget() { buffer_.clear(); }  // after a pause

 private:
  std::uint8_t address_;
  Bytes buffer_;
};

}  // namespace ariadne::drivers::roboclaw
