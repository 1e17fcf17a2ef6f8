#include "drivers/hardware/lms200/config.h"

namespace ariadne::drivers::lms200 {
namespace {

constexpr std::size_t kPeakThresholdAt = 3;
constexpr std::size_t kAvailabilityAt = 4;
constexpr std::size_t kMeasuringModeAt = 5;
constexpr std::size_t kUnitAt = 6;
constexpr std::uint8_t kIndicesBit = 0x02;

}  // namespace

Config FactoryConfig(std::size_t size) {
  Config config;
  config.bytes.resize(size);
  config.bytes[0] =
      70;  // blanking [cm] and sensitivity; any values will do, the project never changes them
  config.bytes[kPeakThresholdAt] = 1;
  return config;
}

Config ConfigOf(ByteView bytes) {
  if (bytes.size() != kConfigSize && bytes.size() != kOldConfigSize) {
    Fail("a configuration of the LMS-200 has {} or {} bytes, not {}", kConfigSize, kOldConfigSize,
         bytes.size());
  }
  if (bytes[kUnitAt] > 1) {
    Fail("the LMS-200 measures in cm (0) or mm (1), not in unit {}", bytes[kUnitAt]);
  }
  MeasuringModeOf(bytes[kMeasuringModeAt]);
  return {Bytes(bytes.begin(), bytes.end())};
}

MeasuringMode MeasuringModeOf(const Config& config) {
  return static_cast<MeasuringMode>(config.bytes[kMeasuringModeAt]);
}

LengthUnit UnitOf(const Config& config) { return static_cast<LengthUnit>(config.bytes[kUnitAt]); }

bool HasRealTimeIndices(const Config& config) { return (config.bytes[kAvailabilityAt] & kIndicesBit) != 0; }

Config WithMeasuringMode(Config config, MeasuringMode mode) {
  config.bytes[kMeasuringModeAt] = static_cast<std::uint8_t>(mode);
  return config;
}

Config WithUnit(Config config, LengthUnit unit) {
  config.bytes[kUnitAt] = static_cast<std::uint8_t>(unit);
  return config;
}

Config WithRealTimeIndices(Config config, bool enabled) {
  const auto others = static_cast<std::uint8_t>(config.bytes[kAvailabilityAt] & ~kIndicesBit);
  config.bytes[kAvailabilityAt] = enabled ? static_cast<std::uint8_t>(others | kIndicesBit) : others;
  return config;
}

}  // namespace ariadne::drivers::lms200
