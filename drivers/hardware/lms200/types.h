#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ariadne::drivers::lms200 {

/// What the host may ask (spec 9.2).
enum class Code : std::uint8_t {
  kReset = 0x10,
  kMode = 0x20,
  kScan = 0x30,
  kStatus = 0x31,
  kErrors = 0x32,
  kMean = 0x36,
  kSubrange = 0x37,
  kType = 0x3A,
  kVariant = 0x3B,
  kMeanSubrange = 0x3F,
  kReflectivity = 0x44,
  kPermanentBaud = 0x66,
  kReadConfig = 0x74,
  kWriteConfig = 0x77,
};

/// What the device answers: the code of the command with the device's bit, and three of its own.
constexpr std::uint8_t ReplyTo(Code code) { return static_cast<std::uint8_t>(code) | 0x80; }
constexpr std::uint8_t kPowerOn = 0x90;
constexpr std::uint8_t kResetConfirmed = 0x91;
constexpr std::uint8_t kUnknownCommand = 0x92;

/// The operating modes of command 0x20; those not listed travel as numbers.
enum class Mode : std::uint8_t {
  kInstallation = 0x00,
  kDiagnostic = 0x10,
  kStream = 0x24,
  kOnRequest = 0x25,
  kStreamMean = 0x26,
  kStreamSubrange = 0x27,
  kStreamMeanSubrange = 0x28,
  kStreamFields = 0x29,
  kStreamPartial = 0x2A,
  kSomePartial = 0x2B,
  kBaud38400 = 0x40,
  kBaud19200 = 0x41,
  kBaud9600 = 0x42,
  kBaud500000 = 0x48,
  kStreamReflectivity = 0x50,
};

enum class ModeAnswer : std::uint8_t { kOk = 0, kRefused = 1, kFault = 2 };

constexpr std::string_view kPassword = "SICK_LMS";

/// The rates of the device in the order in which a driver tries them (spec 9.1) [baud].
constexpr std::array<int, 4> kBaudRates{9600, 38400, 19200, 500000};

/// Error for a rate that the device does not have.
Mode ModeOfBaud(int baud);

/// The units of distances.
enum class LengthUnit : std::uint8_t { kCentimetre = 0, kMillimetre = 1 };

constexpr double Metres(LengthUnit unit) { return unit == LengthUnit::kMillimetre ? 0.001 : 0.01; }

/// What the bits of a measured value mean (spec 9.2).
enum class MeasuringMode : std::uint8_t {
  k8mFieldsAbDazzle = 0x00,  // 8 m in mm, 80 m in cm
  k8mReflector = 0x01,       // the same with 8 levels of reflectors
  k8mFieldsAbc = 0x02,
  k16mReflector = 0x03,  // 4 levels
  k16mFieldsAb = 0x04,
  k32mReflector = 0x05,  // 2 levels
  k32mFieldA = 0x06,
  k32m = 0x0F,
  kReflectivity = 0x3F,  // the amplitude of the echo instead of a distance
};

/// Error for a number that is no measuring mode.
MeasuringMode MeasuringModeOf(std::uint8_t number);

/// Field of view and angular resolution. 0.25 deg exists for 100 deg only.
struct Variant {
  std::uint16_t field_of_view = 180;  // [deg]
  std::uint16_t resolution = 50;      // [0.01 deg]

  bool operator==(const Variant&) const = default;
};

/// Whether the device has it.
bool Exists(const Variant& variant);

/// How many beams a sweep of it has.
constexpr std::size_t BeamsOf(const Variant& variant) {
  return variant.field_of_view * std::size_t{100} / variant.resolution + 1;
}

/// How many turns of the mirror it takes: one measures every degree (spec 9.3).
constexpr int TurnsOf(const Variant& variant) { return 100 / variant.resolution; }

/// A sweep of 0.25 deg over 180 deg is made of so many turns, each with a beam per degree.
constexpr int kTurnsOfPartial = 4;

/// The last byte of each reply (spec 9.3).
struct DeviceStatus {
  int severity = 0;          // 0 ok, 1 information, 2 warning, 3 error, 4 fatal
  bool restart = false;      // the device is restarting
  bool implausible = false;  // of the values; unverified, so that nothing is refused for it
  bool polluted = false;     // of the front window

  bool operator==(const DeviceStatus&) const = default;
};

DeviceStatus DeviceStatusOf(std::uint8_t byte);

}  // namespace ariadne::drivers::lms200
