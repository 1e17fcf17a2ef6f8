#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/roboclaw/packet.h"
#include "slam/base/options.h"

namespace ariadne::drivers::roboclaw {

struct MotorsOptions {
  int address = 0x80;
  int baud = 38400;
  double timeout = 0.2;
  double reply_time = 0.03;
  double recovery_time = 1.0;
  double max_speed = 100000.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("address", self.address, Unit(""), Range{0x80, 0x87},
          "of the board; 128 from the factory (Sec. 10)");
    visit("baud", self.baud, Unit("baud"), Range{2400, 460800},
          "38400 in the manufacturer's examples (Sec. 10)");
    visit("timeout", self.timeout, Unit("s"), Range{0.1, 25.5},
          "without commands until the board stops the motors by itself, in steps of 0.1 s");
    visit("reply_time", self.reply_time, Unit("s"), Range{0.001, 1.0},
          "to the end of a reply, beyond what the line needs; adapters keep bytes for up to 16 ms");
    visit("recovery_time", self.recovery_time, Unit("s"), Range{0.0, 60.0},
          "for which a silent board is asked again; wheels that turn are told to stop after 0.1 s of that");
    visit("max_speed", self.max_speed, Unit("pulses/s"), Range{1.0, 1e7}, "that a motor is ever sent");
  }
};

/// Values of motors 1 and 2.
using Pair = std::array<double, 2>;

/// The encoders' counts, which wrap around at 32 bits.
struct EncoderCounts {
  double time = 0.0;  // when the board had the request: it looks at once, adapters keep replies back [s]
  std::array<std::int32_t, 2> counts{};
};

/// How far an encoder has gone from one count to another, across the wrap.
std::int32_t CountsBetween(std::int32_t before, std::int32_t after);

/// A RoboClaw board with two motors and encoders on a line. Whatever becomes of this program, the board
/// stops the motors when it has heard nothing for the timeout. Each call throws an Error with a sentence
/// where the board does not answer within the recovery time; one late answer is no reason to end, but no
/// wheel turns on a command that is older than 0.1 s: then zero speed is sent. A board that was without
/// power for a moment has forgotten its timeout and its counts: before speeds are set and after counts are
/// read it is asked for the timeout, and if that is lost, it is set again, and the call throws an Error
/// once.
class Motors {
 public:
  Motors(std::unique_ptr<ByteStream> line, const MotorsOptions& options);

  /// Finds the board, stops the motors, sets its timeout and reads it back. Error that names what it
  /// reports.
  void Connect();

  /// Speeds of both motors [pulses/s], reached with `acceleration` [pulses/s^2]. Error beyond the largest.
  /// The timeout goes before them, each time: a board that was without power for a moment has forgotten it.
  /// False where the board has answered too late, and was told to stop instead.
  bool SetSpeeds(const Pair& speeds, double acceleration);
  /// As quickly as the board can.
  void Stop();

  EncoderCounts Encoders();
  Pair MeasuredSpeeds();  // [pulses/s]
  Pair Currents();        // [A]
  double Battery();       // [V]
  /// What the board says is wrong, or about to be; empty for nothing.
  std::string Warnings();

  const std::string& version() const { return version_; }
  std::uint64_t repeated() const { return repeated_; }

  /// Whether the wheels were told to turn, and not to stop since: who asks may find that they were, because
  /// the board was silent.
  bool turning() const { return turning_; }

 private:
  Bytes Ask(Code code);
  void Tell(Code code, const Bytes& data);
  std::optional<Bytes> TryAsk(Code code, double give_up);
  bool TryTell(Code code, const Bytes& data, double give_up);
  std::optional<Bytes> Exchange(Code code, const Bytes& request, double deadline);
  bool IsDoubtful(Code code) const;
  void Answered(Code code);
  void Pause();
  void HaltUnheard();
  [[noreturn]] void FailSilent() const;
  std::uint8_t TimeoutNumber() const;
  bool TryFailIfRestarted(double give_up);
  void FailIfRestarted();
  bool Turn(const Bytes& data);
  double GiveUp() const { return line_->Now() + options_.recovery_time; }
  double Deadline(std::size_t bytes) const;

  std::unique_ptr<ByteStream> line_;
  MotorsOptions options_;
  std::string version_;
  std::uint64_t repeated_ = 0;  // requests
  double asked_ = 0.0;          // when the last one had left [s]
  std::vector<Code> late_;      // requests without an answer, which may come yet
  bool turning_ = false;
  bool halting_ = false;  // zero speed was sent, and nobody knows whether it was heard
};

}  // namespace ariadne::drivers::roboclaw
