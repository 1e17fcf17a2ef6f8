#include "drivers/hardware/lms200/status.h"

#include <algorithm>

namespace ariadne::drivers::lms200 {
namespace {

// Where things are, counted with the code as 0.
constexpr std::size_t kSoftwareAt = 1;
constexpr std::size_t kModeAt = 8;
constexpr std::size_t kErrorAt = 9;
constexpr std::size_t kTypeAt = 18;
constexpr std::size_t kRevolutionsAt = 67;
constexpr std::size_t kMeasuringModePlace = 102;
constexpr std::size_t kAngleAt = 107;
constexpr std::size_t kResolutionAt = 109;
constexpr std::size_t kBaudAt = 116;
constexpr std::size_t kPermanentBaudAt = 119;
constexpr std::size_t kAddressAt = 120;
constexpr std::size_t kUnitPlace = 122;
constexpr std::size_t kLaserAt = 123;
constexpr std::size_t kBootPromAt = 124;
constexpr std::size_t kVersionLength = 7;

void PutText(Bytes& payload, std::size_t at, const std::string& text) {
  const std::size_t length = std::min(text.size(), kVersionLength);
  for (std::size_t i = 0; i < length; ++i) payload[at + i] = static_cast<std::uint8_t>(text[i]);
}

std::string TextAt(ByteView payload, std::size_t at) {
  const ByteView bytes = payload.subspan(at, kVersionLength);
  std::string text(bytes.begin(), bytes.end());
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

void PutWord(Bytes& payload, std::size_t at, std::uint16_t word) {
  payload[at] = static_cast<std::uint8_t>(word & 0xFF);
  payload[at + 1] = static_cast<std::uint8_t>(word >> 8);
}

std::uint16_t WordAt(ByteView payload, std::size_t at) {
  return static_cast<std::uint16_t>(payload[at] | payload[at + 1] << 8);
}

/// Rates travel as what 1 MHz is divided by, less one, with the highest bit set: 0x8067 is 9600 baud. (The
/// spec gives the place only; the words are the telegram listing's.)
constexpr std::uint16_t kBaudBit = 0x8000;

std::uint16_t WordOfBaud(int baud) {
  return static_cast<std::uint16_t>(kBaudBit | ((1000000 + baud / 2) / baud - 1));
}

int BaudOfWord(std::uint16_t word) {
  for (const int baud : kBaudRates) {
    if (WordOfBaud(baud) == word) return baud;
  }
  Fail("the LMS-200 has no baud rate 0x{:04X}", word);
}

/// The number of a byte that says yes or no.
bool FlagAt(ByteView payload, std::size_t at) { return payload[at] != 0; }

}  // namespace

Bytes EncodeStatus(const StatusReply& status) {
  Bytes payload(kStatusSize);
  payload[0] = ReplyTo(Code::kStatus);
  PutText(payload, kSoftwareAt, status.software);
  payload[kModeAt] = static_cast<std::uint8_t>(status.mode);
  payload[kErrorAt] = status.error;
  payload[kTypeAt] = status.type;
  PutWord(payload, kRevolutionsAt, status.motor_revolutions);
  payload[kMeasuringModePlace] = static_cast<std::uint8_t>(status.measuring_mode);
  PutWord(payload, kAngleAt, status.variant.field_of_view);
  PutWord(payload, kResolutionAt, status.variant.resolution);
  PutWord(payload, kBaudAt, WordOfBaud(status.baud));
  payload[kPermanentBaudAt] = status.permanent_baud ? 1 : 0;
  payload[kAddressAt] = status.address;
  payload[kUnitPlace] = static_cast<std::uint8_t>(status.unit);
  payload[kLaserAt] = status.laser_on ? 1 : 0;
  PutText(payload, kBootPromAt, status.boot_prom);
  payload.back() = status.status;
  return payload;
}

StatusReply DecodeStatus(ByteView payload) {
  if (payload.size() != kStatusSize || payload[0] != ReplyTo(Code::kStatus)) {
    Fail("a status of the LMS-200 is {} bytes from 0xB1 on, not {} from 0x{:02X}", kStatusSize,
         payload.size(), payload.empty() ? 0 : payload[0]);
  }
  if (payload[kUnitPlace] > 1) Fail("the LMS-200 has no unit {}", payload[kUnitPlace]);
  StatusReply status;
  status.software = TextAt(payload, kSoftwareAt);
  status.mode = static_cast<Mode>(payload[kModeAt]);
  status.error = payload[kErrorAt];
  status.type = payload[kTypeAt];
  status.motor_revolutions = WordAt(payload, kRevolutionsAt);
  status.measuring_mode = MeasuringModeOf(payload[kMeasuringModePlace]);
  status.variant = {WordAt(payload, kAngleAt), WordAt(payload, kResolutionAt)};
  if (!Exists(status.variant)) {
    Fail("the LMS-200 has no variant of {} deg in steps of {}/100 deg", status.variant.field_of_view,
         status.variant.resolution);
  }
  status.baud = BaudOfWord(WordAt(payload, kBaudAt));
  status.permanent_baud = FlagAt(payload, kPermanentBaudAt);
  status.address = payload[kAddressAt];
  status.unit = static_cast<LengthUnit>(payload[kUnitPlace]);
  status.laser_on = FlagAt(payload, kLaserAt);
  status.boot_prom = TextAt(payload, kBootPromAt);
  status.status = payload.back();
  return status;
}

}  // namespace ariadne::drivers::lms200
