#pragma once

#include <cstdint>

#include "drivers/hardware/wire.h"

namespace ariadne::drivers::lms200 {

constexpr std::uint8_t kStxByte = 0x02;
constexpr std::uint8_t kAckByte = 0x06;
constexpr std::uint8_t kNakByte = 0x15;
constexpr std::size_t kMaxPayload = 812;  // [B], spec 9.1
constexpr std::size_t kFrameSize = 6;     // what a frame adds to its payload [B]

/// The device sets this bit in its address and in the code of a reply.
constexpr std::uint8_t kFromDevice = 0x80;

/// One telegram of either side. The payload is the command and its data, or the code of a reply, its data
/// and the status byte (spec 9.1).
struct Telegram {
  std::uint8_t address = 0;
  Bytes payload;

  bool operator==(const Telegram&) const = default;
};

/// The checksum of spec 9.1 over all bytes before it, from STX on. It is no standard CRC-16: it shifts by
/// one bit per byte, so that byte i counts like byte i + 1 shifted by one bit. Each wrong byte is found;
/// two wrong bits on such a diagonal (bit k of byte i and bit k + 1 of byte i + 1) are not, whoever checks.
std::uint16_t Crc(ByteView bytes);

/// The bytes of a telegram on the line. Error if the payload is empty or longer than 812 bytes.
Bytes EncodeTelegram(const Telegram& telegram);

}  // namespace ariadne::drivers::lms200
