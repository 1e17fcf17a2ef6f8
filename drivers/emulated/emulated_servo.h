#pragma once

#include <array>
#include <vector>

#include "drivers/emulated/emulated_device.h"
#include "drivers/emulated/position_memory.h"
#include "drivers/hardware/dynamixel/packet.h"
#include "drivers/hardware/dynamixel/servo.h"

namespace ariadne::drivers {

struct EmulatedServoOptions {
  int id = 1;
  int baud = 57600;
  int model = 1060;
  double position = 180.0;
  double return_delay = 0.0005;
  bool echo = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("id", self.id, Unit(""), Range{0, 252}, "on its bus");
    visit("baud", self.baud, Unit("baud"), Range{9600, 4500000}, "57600 from the factory (Sec. 10)");
    visit("model", self.model, Unit(""), Range{0, 65535}, "number; 1060 is an XL430-W250");
    visit("position", self.position, Unit("deg"), Range{0.0, 360.0}, "when it is switched on");
    visit("return_delay", self.return_delay, Unit("s"), Range{0.0, 0.01}, "before a reply");
    visit("echo", self.echo, "whether the adapter of the half-duplex bus returns what is sent");
  }
};

/// A Dynamixel servo of the X series in position mode: ping, read, write, sync write, reboot, and the part
/// of the control table that the driver's Place names. Choices where the specification is silent: without
/// profile (0) it moves with 6 rad/s and 40 rad/s^2; without torque it stands; reads and writes beyond byte
/// 255 are out of range (error 4); instructions that it does not know get error 2; wrong checksums get no
/// answer.
class EmulatedServo : public EmulatedDevice {
 public:
  explicit EmulatedServo(const EmulatedServoOptions& options = {});

  void Receive(ByteView bytes, int baud, double time) override;
  double NextTime() const override;
  std::vector<Sending> Advance(double time) override;
  void LosePower(double time, double seconds) override;

  /// Where it is [turns], at the latest time that it was told.
  double position() const { return position_; }
  /// And where it was a moment before, within the last second.
  double PositionAt(double time) const { return memory_.At(time, position_); }

  /// Something holds the mount: it does not move, and reports an overload after a second of trying.
  void SetStuck(bool stuck) { stuck_ = stuck; }

 private:
  std::int32_t NumberAt(dynamixel::Place place) const;
  std::uint8_t& ByteAt(dynamixel::Place place) { return table_[static_cast<std::size_t>(place)]; }
  void PutNumber(dynamixel::Place place, std::int32_t value);
  void SetDefaults();
  void Move(double time);
  void Step(double seconds);
  void Execute(const dynamixel::Packet& packet, double time);
  std::uint8_t WriteTable(std::size_t address, ByteView data);
  void SyncWrite(ByteView parameters);
  void Reply(std::uint8_t error, const Bytes& data, double time);

  EmulatedServoOptions options_;
  dynamixel::PacketDecoder decoder_;
  std::array<std::uint8_t, 256> table_{};
  double position_;  // [turns]
  PositionMemory memory_;
  double velocity_ = 0.0;  // [turns/s]
  double now_ = 0.0;       // [s]
  double ready_at_ = 0.0;  // [s]
  double overload_ = 0.0;  // time of trying in vain [s]
  bool stuck_ = false;
  double sent_until_ = 0.0;
  std::vector<Sending> sendings_;
};

}  // namespace ariadne::drivers
