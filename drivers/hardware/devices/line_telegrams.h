#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "drivers/hardware/devices/identify.h"
#include "drivers/hardware/recorded_stream.h"

namespace ariadne::drivers {

/// What a scanner measured in one telegram: a sweep, or one turn of a finer one.
struct LineSweep {
  double first_angle = 0.0;   // of the first beam, 0 is to the right [rad]
  double angle_step = 0.0;    // [rad]
  double line_time = 0.0;     // that the telegram took on the line [s]
  std::vector<float> ranges;  // NaN where there is no distance [m]
};

/// Where a servo said it was.
struct LineAngle {
  double turns = 0.0;  // as the servo counts
};

/// What a motor board's encoders had counted.
struct LineCounts {
  std::array<std::int32_t, 2> counts{};
};

/// A telegram of one side, found again in what crossed a line.
struct LineTelegram {
  double time = 0.0;       // when the call that wrote it, or read its end, returned [s]
  bool to_device = false;  // else from it
  bool bad = false;        // damaged, without answer, or the device reports an error
  std::string text;        // what it says, for people
  std::variant<std::monostate, LineSweep, LineAngle, LineCounts> value;
};

/// Finds the telegrams of one line, record by record in their order.
class TelegramReader {
 public:
  virtual ~TelegramReader() = default;

  /// Those that end with this record.
  virtual std::vector<LineTelegram> Take(const LineRecord& record) = 0;
};

std::unique_ptr<TelegramReader> MakeTelegramReader(DeviceKind kind);

/// Tells by what crossed a line what is on it: the device in whose way most of it can be read.
class DeviceGuess {
 public:
  DeviceGuess();
  void Take(const LineRecord& record);

  struct Seen {
    DeviceKind kind = DeviceKind::kLms200;
    std::uint64_t telegrams = 0;  // whole ones of the device
    std::uint64_t bad = 0;
    std::uint64_t sent = 0;  // to the device
  };
  /// Nobody has answered where it has no telegrams.
  Seen Best() const;

 private:
  std::vector<Seen> seen_;
  std::vector<std::unique_ptr<TelegramReader>> readers_;
};

// One per device:
std::unique_ptr<TelegramReader> MakeLms200Reader();
std::unique_ptr<TelegramReader> MakeDynamixelReader();
std::unique_ptr<TelegramReader> MakeRoboclawReader();
std::unique_ptr<TelegramReader> MakeMaestroReader();

}  // namespace ariadne::drivers
