#include "drivers/hardware/lms200/telegram.h"

namespace ariadne::drivers::lms200 {

std::uint16_t Crc(ByteView bytes) {
  constexpr std::uint32_t kPolynomial = 0x8005;
  std::uint32_t crc = 0;
  std::uint32_t previous = 0;
  for (const std::uint8_t byte : bytes) {
    crc <<= 1;
    if ((crc & 0x10000) != 0) crc = (crc & 0xFFFF) ^ kPolynomial;
    crc ^= byte | previous << 8;
    previous = byte;
  }
  return static_cast<std::uint16_t>(crc);
}

Bytes EncodeTelegram(const Telegram& telegram) {
  const std::size_t length = telegram.payload.size();
  if (length == 0 || length > kMaxPayload) {
    Fail("a telegram of the LMS-200 carries 1 to {} bytes, not {}", kMaxPayload, length);
  }
  WireWriter writer;
  writer.Byte(kStxByte);
  writer.Byte(telegram.address);
  writer.Word(static_cast<std::uint16_t>(length));
  writer.Rest(telegram.payload);
  Bytes bytes = writer.Finish();
  const std::uint16_t crc = Crc(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return bytes;
}

}  // namespace ariadne::drivers::lms200
