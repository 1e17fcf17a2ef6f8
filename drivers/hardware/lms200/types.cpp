#include "drivers/hardware/lms200/types.h"

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne::drivers::lms200 {

Mode ModeOfBaud(int baud) {
  switch (baud) {
    case 9600:
      return Mode::kBaud9600;
    case 19200:
      return Mode::kBaud19200;
    case 38400:
      return Mode::kBaud38400;
    case 500000:
      return Mode::kBaud500000;
    default:
      Fail("the LMS-200 has 9600, 19200, 38400 and 500000 baud, not {}", baud);
  }
}

MeasuringMode MeasuringModeOf(std::uint8_t number) {
  constexpr std::array<std::uint8_t, 9> kNumbers{0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x0F, 0x3F};
  if (std::find(kNumbers.begin(), kNumbers.end(), number) == kNumbers.end()) {
    Fail("the LMS-200 has no measuring mode 0x{:02X}", number);
  }
  return static_cast<MeasuringMode>(number);
}

bool Exists(const Variant& variant) {
  const bool half_or_whole = variant.resolution == 100 || variant.resolution == 50;
  if (variant.field_of_view == 180) return half_or_whole;
  return variant.field_of_view == 100 && (half_or_whole || variant.resolution == 25);
}

DeviceStatus DeviceStatusOf(std::uint8_t byte) {
  DeviceStatus status;
  status.severity = byte & 0x07;
  status.restart = (byte & 0x20) != 0;
  status.implausible = (byte & 0x40) != 0;
  status.polluted = (byte & 0x80) != 0;
  return status;
}

}  // namespace ariadne::drivers::lms200
