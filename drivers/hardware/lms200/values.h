#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "drivers/hardware/lms200/types.h"
#include "drivers/hardware/wire.h"

namespace ariadne::drivers::lms200 {

/// Counters modulo 256 that the device adds to measured values if bit 1 of its availability is set.
struct RealTimeIndices {
  std::uint8_t scan = 0;
  std::uint8_t telegram = 0;

  bool operator==(const RealTimeIndices&) const = default;
};

/// A telegram of measured values: 0xB0 (all), 0xB6 (mean), 0xB7 (subrange), 0xBF (mean of a subrange), 0xC4
/// (all, with the reflectivity of a subrange; S14 models only).
struct MeasuredValues {
  std::uint8_t code = ReplyTo(Code::kScan);
  std::uint8_t samples = 0;  // in a mean
  std::uint16_t first = 0;   // beams of the subrange from 1 on, both included
  std::uint16_t last = 0;
  LengthUnit unit = LengthUnit::kCentimetre;
  bool partial = false;              // one turn of a finer sweep ...
  int offset = 0;                    // ... whose beams lie so many 0.25 deg further
  std::vector<std::uint16_t> words;  // as sent, with flags
  Bytes reflectivity;                // of beams first to last
  std::optional<RealTimeIndices> indices;
  std::uint8_t status = 0;  // see DeviceStatusOf

  bool operator==(const MeasuredValues&) const = default;
};

/// Whether a reply of this code carries measured values.
bool IsMeasuredValues(std::uint8_t code);

/// The payload of the telegram. Error if it would be too long.
Bytes EncodeMeasuredValues(const MeasuredValues& values);

/// Error unless length, counts, unit and subrange agree with each other and with what the device can
/// measure.
MeasuredValues DecodeMeasuredValues(ByteView payload);

/// Why a word is no distance (spec 9.3).
enum class ValueError { kNone, kNotValid, kDazzled, kOverflow, kWeakSignal, kChannel, kTooFar, kUnnamed };

std::string_view NameOf(ValueError error);

/// What one measured value says. In mode 0x3F words are amplitudes and never distances.
struct Echo {
  std::uint16_t number = 0;  // of units, or the amplitude
  ValueError error = ValueError::kNone;
  std::uint8_t flags = 0;  // the bits above the number, shifted down: fields, dazzle, or reflector level
};

/// How many bits of a word are the distance.
int DistanceBits(MeasuringMode mode);

Echo EchoOf(std::uint16_t word, MeasuringMode mode);

/// How many reflector levels the mode tells apart above 0; 0 where its flags are no levels.
int ReflectorLevels(MeasuringMode mode);

}  // namespace ariadne::drivers::lms200
