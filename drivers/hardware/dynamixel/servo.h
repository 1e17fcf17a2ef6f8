#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/dynamixel/packet.h"
#include "slam/base/options.h"

namespace ariadne::drivers::dynamixel {

/// Places in the control table of the X series (spec, section 10, and the manufacturer's table).
enum class Place : std::uint16_t {
  kModel = 0,
  kOperatingMode = 11,  // 3 position
  kTorqueEnable = 64,
  kHardwareError = 70,  // bits: 0 voltage, 2 temperature, 3 encoder, 4 electrical shock, 5 overload
  kBusWatchdog = 98,    // [20 ms], 0 for none
  kProfileAcceleration = 108,
  kProfileVelocity = 112,
  kGoalPosition = 116,
  kMoving = 122,
  kPresentVelocity = 128,
  kPresentPosition = 132,
};

// Units of the table.
constexpr int kStepsPerTurn = 4096;
constexpr double kVelocityUnit = 0.229 / 60.0;                 // [turns/s]
constexpr double kAccelerationUnit = 214.577 / (60.0 * 60.0);  // [turns/s^2]

struct ServoOptions {
  int id = 1;
  int baud = 57600;
  double zero = 180.0;
  bool reversed = false;
  double min_angle = -1.4;
  double max_angle = 1.4;
  double reply_time = 0.02;
  double recovery_time = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("id", self.id, Unit(""), Range{0, 252}, "of the servo on its bus; 1 from the factory");
    visit("baud", self.baud, Unit("baud"), Range{9600, 4500000}, "57600 from the factory (Sec. 10)");
    visit("zero", self.zero, Unit("deg"), Range{0.0, 360.0}, "position where the angle is 0");
    visit("reversed", self.reversed, "whether larger positions are smaller angles");
    visit("min_angle", self.min_angle, Unit("rad"), Range{-3.14, 3.14}, "that the mount bears");
    visit("max_angle", self.max_angle, Unit("rad"), Range{-3.14, 3.14}, "that the mount bears");
    visit("reply_time", self.reply_time, Unit("s"), Range{0.001, 1.0},
          "to the end of a reply, beyond what the line needs; adapters keep bytes for up to 16 ms");
    visit("recovery_time", self.recovery_time, Unit("s"), Range{0.0, 60.0},
          "for which a silent servo is asked again");
  }
};

/// Where a servo is, measured by itself.
struct ServoState {
  double time = 0.0;      // when the request had left: adapters hold back replies, but not requests [s]
  double angle = 0.0;     // [rad]
  double velocity = 0.0;  // [rad/s]
};

/// A Dynamixel servo of the X series in position mode, for example one that tilts the scanner. Angles are
/// those of the mount. Each call throws an Error with a sentence where the servo does not answer or reports
/// a fault.
class Servo {
 public:
  Servo(std::unique_ptr<ByteStream> line, const ServoOptions& options);

  /// Finds the servo, clears its torque, and sets it up. Error that names what it reports.
  void Connect();

  void SetTorque(bool enabled);

  /// Limits of the motions that follow [rad/s, rad/s^2].
  void SetProfile(double velocity, double acceleration);

  /// Begins a motion; does not wait. Error beyond the limits of the mount.
  void MoveTo(double angle);

  ServoState State();

  /// Waits until it is within `tolerance` of `angle` [rad]. Error if it is not there after `seconds`.
  void WaitFor(double angle, double tolerance, double seconds);

  /// What the servo says is wrong with it; empty for nothing.
  std::string HardwareError();

  int model() const { return model_; }
  std::uint64_t repeated() const { return repeated_; }

 private:
  Bytes Ask(const Packet& packet, std::size_t data_size);
  std::optional<Packet> AskOnce(const Packet& packet);
  void WriteByte(Place place, std::uint8_t value);
  void WriteNumber(Place place, std::int64_t value);
  void FailIfFaulty(std::uint8_t error);

  std::unique_ptr<ByteStream> line_;
  ServoOptions options_;
  PacketDecoder decoder_;
  int model_ = 0;
  double asked_ = 0.0;          // when the last request had left [s]
  std::uint64_t repeated_ = 0;  // questions
};

}  // namespace ariadne::drivers::dynamixel
