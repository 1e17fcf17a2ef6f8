#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "drivers/emulated/emulated_device.h"
#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram_decoder.h"
#include "slam/base/options.h"
#include "slam/base/random.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// What a scanner would measure: a sweep of `beams` beams that begins at `stamp` [s]. Ranges are metres and
/// kNoReturn; reflectance is 0 to 1, or empty.
using SweepSource =
    std::function<slam::LaserSweep(double stamp, const slam::ScannerModel& scanner, std::size_t beams)>;

struct EmulatedLms200Options {
  double turn_period = 1.0 / 75.0;
  double ack_delay = 0.002;
  double reply_delay = 0.003;
  double mode_delay = 0.05;
  double boot_time = 2.0;
  bool strict = true;
  bool paced = true;
  bool reply_at_new_baud = false;
  bool s14 = false;
  bool old_config = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("turn_period", self.turn_period, Unit("s"), Range{0.005, 0.1}, "of the mirror; 75 turns/s (9.3)");
    visit("ack_delay", self.ack_delay, Unit("s"), Range{0.0, 0.06}, "to ACK or NAK; at most 60 ms (9.1)");
    visit("reply_delay", self.reply_delay, Unit("s"), Range{0.0, 1.0}, "from the ACK to the reply");
    visit("mode_delay", self.mode_delay, Unit("s"), Range{0.0, 3.0}, "the same for modes; up to 3 s (9.1)");
    visit("boot_time", self.boot_time, Unit("s"), Range{0.0, 60.0},
          "after power-on and reset; up to 60 s (9.2)");
    visit("strict", self.strict, "whether only what the specification allows is done");
    visit("paced", self.paced, "whether bytes take the time that they need at the baud rate");
    visit("reply_at_new_baud", self.reply_at_new_baud, "to a change of the rate; else at the old one");
    visit("s14", self.s14, "whether it is a fast model, which measures reflectivity with ranges (9.4)");
    visit("old_config", self.old_config, "whether its configuration has 32 bytes instead of 34 (9.2)");
  }
};

/// A SICK LMS-200 as specification, section 9, describes it. Where that is silent, and what strict means:
/// - Both kinds answer an unknown command with 0x92, and with NAK what has a wrong checksum, or the wrong
///   length for its command.
/// - Strict refuses to write its configuration (0x77) outside installation mode and to change the variant
///   outside modes 0x25 and installation, sends NAK to 0x30 and its like outside mode 0x25, is deaf to
///   other addresses, and forgets half a telegram after a pause of 14 ms. Lenient does all that it can
///   understand.
/// - 0.25 deg at 180 deg, the S14's reflectivity on other models, and a wrong password are refused by both.
/// - It answers requests between two telegrams of a stream; a sweep that ends while the line is busy is
/// lost.
/// - Mode 0x2A sends each turn with the offsets 0, 0.25, 0.5, 0.75 deg in turn, whatever the resolution;
/// 0x2B
///   n sends n of them and falls silent. Mode 0x29 is answered like 0x27; 0x2C and 0x2E are refused.
/// - A sweep asked for is the next one to end. Sweeps follow each other from when the device is ready.
/// - The variant after power-on is 180 deg in steps of 0.5 deg.
/// - Echoes beyond the largest distance, and those that do not come, are 0x1FF7, above the maximum.
class EmulatedLms200 : public EmulatedDevice {
 public:
  /// Powered on at time 0, and ready after its boot.
  EmulatedLms200(const EmulatedLms200Options& options, SweepSource source);

  void Receive(ByteView bytes, int baud, double time) override;
  double NextTime() const override;
  std::vector<Sending> Advance(double time) override;
  void LosePower(double time, double seconds) override;

  /// The status byte of all that it sends, for example 0x90 with a polluted window.
  void SetStatus(std::uint8_t status) { status_ = status; }
  void SetErrors(std::vector<lms200::ErrorReply::Entry> errors) { errors_ = std::move(errors); }

  int baud() const { return baud_; }
  lms200::Mode mode() const { return mode_; }
  const lms200::Variant& variant() const { return variant_; }
  const lms200::Config& config() const { return config_; }
  int config_writes() const { return config_writes_; }

 private:
  struct Event {
    double time;
    Bytes bytes;
    std::function<void()> then;
  };
  /// Sweeps that were asked for, or that are sent without being asked.
  struct Measuring {
    std::uint8_t code = 0xB0;
    bool partial = false;
    int left = -1;  // how many sweeps still; -1 for ever
    int samples = 1;
    std::uint16_t first = 0;
    std::uint16_t last = 0;
  };

  void Boot(double time);
  void BecomeReady();
  std::string TypeText() const;

  void Execute(Bytes payload, double time);
  void ExecuteMode(const lms200::Command& command, double time);
  void ExecuteVariant(const lms200::Command& command, double time);
  void ExecuteWrite(const lms200::Command& command, double time);
  void ExecuteMeasure(const lms200::Command& command, double time);
  std::optional<Measuring> MeasuringOf(const lms200::Command& command) const;
  lms200::StatusReply Status() const;
  lms200::Reply SimpleReply(lms200::Code code) const;

  void Send(double time, Bytes bytes, std::function<void()> then = {});
  void Acknowledge(double time, const lms200::Reply& reply, double delay, std::function<void()> then = {});
  void Refuse(double time);
  void Transmit(double time, Bytes bytes);

  std::size_t BeamsOfMeasuring() const;
  int TurnsOfMeasuring() const;
  double SweepEnd() const;
  void Measure();
  lms200::MeasuredValues Values(std::int64_t turn);
  std::vector<std::uint16_t> WordsOf(const slam::LaserSweep& sweep) const;

  EmulatedLms200Options options_;
  SweepSource source_;
  lms200::TelegramDecoder decoder_{lms200::Sender::kHost};
  RandomStream noise_;

  // What lasts without power:
  lms200::Config config_;
  int power_on_baud_ = 9600;
  int config_writes_ = 0;
  std::vector<lms200::ErrorReply::Entry> errors_;
  std::uint8_t status_ = 0x10;

  // What does not:
  int baud_ = 9600;
  lms200::Mode mode_ = lms200::Mode::kOnRequest;
  lms200::Variant variant_;
  std::optional<Measuring> measuring_;
  std::vector<slam::LaserSweep> mean_;
  std::deque<Event> events_;  // in the order of their times
  double ready_at_ = 0.0;
  bool ready_ = false;
  double now_ = 0.0;
  double received_until_ = 0.0;
  double sent_until_ = 0.0;
  std::int64_t next_turn_ = 0;  // first turn of the next sweep
  std::uint8_t telegrams_ = 0;
  std::vector<Sending> sendings_;
};

}  // namespace ariadne::drivers
