#pragma once

#include <string>

#include "drivers/hardware/lms200/types.h"
#include "drivers/hardware/wire.h"

namespace ariadne::drivers::lms200 {

constexpr std::size_t kStatusSize = 154;  // of the payload of 0xB1: code, 152 bytes, status byte

/// What 0xB1 says of a device (spec 9.2). The other bytes are read over, and written as zeros.
struct StatusReply {
  std::string software;  // version, 7 characters
  Mode mode = Mode::kOnRequest;
  std::uint8_t error = 0;               // 0 none, else as DeviceStatus::severity
  std::uint8_t type = 6;                // of the device; the spec's "variant" at 18, 6 for the LMS-200
  std::uint16_t motor_revolutions = 0;  // the device's own measure
  MeasuringMode measuring_mode = MeasuringMode::k8mFieldsAbDazzle;
  Variant variant;
  int baud = 9600;
  bool permanent_baud = false;  // whether `baud` is also that of the next power-on
  std::uint8_t address = 0;
  LengthUnit unit = LengthUnit::kCentimetre;
  bool laser_on = true;
  std::string boot_prom;  // version, 7 characters
  std::uint8_t status = 0x10;

  bool operator==(const StatusReply&) const = default;
};

Bytes EncodeStatus(const StatusReply& status);

/// Error unless it has the right length and says what a device can be.
StatusReply DecodeStatus(ByteView payload);

}  // namespace ariadne::drivers::lms200
