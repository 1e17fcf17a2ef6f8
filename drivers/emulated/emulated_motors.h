#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "drivers/emulated/emulated_device.h"
#include "drivers/hardware/roboclaw/packet.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

struct EmulatedMotorsOptions {
  int address = 0x80;
  int baud = 38400;
  double reply_delay = 0.001;
  double battery = 24.4;
  double deceleration = 20000.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("address", self.address, Unit(""), Range{0x80, 0x87}, "of the board");
    visit("baud", self.baud, Unit("baud"), Range{2400, 460800},
          "38400 in the manufacturer's examples (Sec. 10)");
    visit("reply_delay", self.reply_delay, Unit("s"), Range{0.0, 0.01}, "before a reply");
    visit("battery", self.battery, Unit("V"), Range{0.0, 60.0}, "of the motors");
    visit("deceleration", self.deceleration, Unit("pulses/s^2"), Range{1.0, 1e9},
          "of a stop after the timeout");
  }
};

/// What the wheels are coupled to: of ways [pulses] up to a time [s] it lets a share happen, 1 for all.
using MotorLoad = std::function<double(const std::array<double, 2>& ways, double time)>;

/// A RoboClaw board with two motors that do what they are told, within their acceleration. Choices where
/// the specification is silent: requests that it cannot read get no answer and do not keep the timeout from
/// running out; half a packet is forgotten after 10 ms; speeds are those of the encoders at this moment;
/// the timeout is 0 (never) after power-on.
class EmulatedMotors : public EmulatedDevice {
 public:
  explicit EmulatedMotors(const EmulatedMotorsOptions& options = {});

  void Receive(ByteView bytes, int baud, double time) override;
  double NextTime() const override;
  std::vector<Sending> Advance(double time) override;
  void LosePower(double time, double seconds) override;

  /// How the wheels turn now [pulses/s], for the world that they move.
  const std::array<double, 2>& speeds() const { return speeds_; }
  const std::array<double, 2>& positions() const { return positions_; }  // [pulses]

  /// The world in which the wheels roll, every 10 ms. What it stops stands, with a large current, and
  /// tries again.
  void SetLoad(MotorLoad load) { load_ = std::move(load); }
  /// Rolls up to this moment.
  void Couple();

  /// Bits of command 90.
  void SetStatus(std::uint16_t status) { status_ = status; }
  /// A wheel that is blocked stands, with a large current.
  void SetBlocked(int motor, bool blocked) { blocked_[static_cast<std::size_t>(motor)] = blocked; }

 private:
  void Move(double time);
  void MoveFor(double seconds);
  void MoveCoupled(double seconds);
  void Execute(const roboclaw::Request& request, double time);
  Bytes DataOf(roboclaw::Code code) const;
  double TimeoutEnds() const;

  EmulatedMotorsOptions options_;
  roboclaw::RequestDecoder decoder_;
  std::array<double, 2> positions_{};
  std::array<double, 2> zero_{};  // positions where the encoders were reset
  std::array<double, 2> speeds_{};
  std::array<double, 2> targets_{};
  std::array<bool, 2> blocked_{};
  MotorLoad load_;
  std::array<double, 2> rolled_{};  // positions up to which the load has let them
  double rolled_until_ = 0.0;       // [s]
  bool held_ = false;               // by the load
  double acceleration_;
  std::uint16_t status_ = 0;
  std::uint8_t timeout_ = 0;  // [100 ms]
  double heard_ = 0.0;        // the last valid request [s]
  double received_ = 0.0;     // the last bytes [s]
  double now_ = 0.0;
  double ready_at_ = 0.0;
  double sent_until_ = 0.0;
  std::vector<Sending> sendings_;
};

}  // namespace ariadne::drivers
