#pragma once

#include "drivers/hardware/lms200/types.h"
#include "drivers/hardware/wire.h"

namespace ariadne::drivers::lms200 {

/// The configuration in the device's EEPROM (spec 9.2): 34 bytes, of which older firmware has the first 32.
/// All bytes are kept as they were read, so that one can be changed and the rest be written back.
struct Config {
  Bytes bytes;

  bool operator==(const Config&) const = default;
};

constexpr std::size_t kConfigSize = 34;
constexpr std::size_t kOldConfigSize = 32;

/// As a device leaves the factory (spec 9.2: mode 0x00; cm is the choice here, the spec gives no default).
Config FactoryConfig(std::size_t size = kConfigSize);

/// Error unless it has 34 or 32 bytes, a measuring mode and a unit.
Config ConfigOf(ByteView bytes);

MeasuringMode MeasuringModeOf(const Config& config);
LengthUnit UnitOf(const Config& config);
bool HasRealTimeIndices(const Config& config);

/// The same configuration with one thing changed.
Config WithMeasuringMode(Config config, MeasuringMode mode);
Config WithUnit(Config config, LengthUnit unit);
Config WithRealTimeIndices(Config config, bool enabled);

}  // namespace ariadne::drivers::lms200
