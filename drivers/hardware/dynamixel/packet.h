#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers::dynamixel {

/// What packets of protocol 2.0 ask or answer (spec, section 10).
enum class Instruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kReboot = 0x08,
  kStatus = 0x55,
  kSyncWrite = 0x83,
};

constexpr std::uint8_t kBroadcast = 0xFE;
constexpr std::size_t kMaxLength = 1024;  // of instruction, parameters and checksum on the line [B]

struct Packet {
  std::uint8_t id = 1;
  std::uint8_t instruction = 0;  // see Instruction
  Bytes parameters;              // of a status: its error, and then the data

  bool operator==(const Packet&) const = default;
};

/// CRC-16 with polynomial 0x8005 from 0, highest bit first.
std::uint16_t Crc(ByteView bytes);

/// The bytes on the line. An FD is stuffed in after each FF FF FD behind the length, so that nothing within
/// a packet looks like the beginning of one. Error if it is too long.
Bytes EncodePacket(const Packet& packet);

Packet Ping(std::uint8_t id);
Packet Reboot(std::uint8_t id);
Packet Read(std::uint8_t id, std::uint16_t address, std::uint16_t count);
Packet Write(std::uint8_t id, std::uint16_t address, ByteView data);

/// The same place of several devices at once; none of them answers.
struct SyncValue {
  std::uint8_t id;
  Bytes data;
};
Packet SyncWrite(std::uint16_t address, const std::vector<SyncValue>& values);

/// Finds packets in a stream of bytes, whatever stands between them and however it is cut.
class PacketDecoder {
 public:
  void Push(ByteView bytes);

  /// The next packet, none until more bytes come. Wrong ones are counted and passed over.
  std::optional<Packet> Next();

  /// Takes what has begun like a packet for garbage, because the rest does not come.
  void GiveUp();

  bool IsWaiting() const { return begin_ < buffer_.size(); }
  std::uint64_t bad() const { return bad_; }

 private:
  enum class Found { kNothing, kIncomplete, kBad, kPacket };
  Found Look(ByteView rest) const;

  Bytes buffer_;
  std::size_t begin_ = 0;
  std::uint64_t bad_ = 0;
};

}  // namespace ariadne::drivers::dynamixel
