#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/lms200/link.h"
#include "drivers/hardware/lms200/sweep_clock.h"
#include "slam/base/options.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

struct Lms200Options {
  int baud = 500000;
  int field_of_view = 180;
  double resolution = 0.5;
  int measuring_mode = 0x00;
  bool millimetres = false;
  bool write_config = false;
  bool reflectivity = false;
  double turn_period = 1.0 / 75.0;
  double output_delay = 0.0;
  double recovery_time = 70.0;
  double quiet_time = 0.5;
  lms200::SweepClockOptions clock;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("baud", self.baud, Unit("baud"), Range{9600, 500000}, "13 ms per slice needs 500000 (9.3)");
    visit("field_of_view", self.field_of_view, Unit("deg"), Range{100, 180}, "100 or 180 (9.2)");
    visit("resolution", self.resolution, Unit("deg"), Range{0.25, 1.0}, "1, 0.5 or 0.25 (9.2)");
    visit("measuring_mode", self.measuring_mode, Unit(""), Range{0, 63},
          "range and flags, as numbered in 9.2");
    visit("millimetres", self.millimetres, "8 m in mm; else 80 m in cm, as the paper's 15 m need (9.3)");
    visit("write_config", self.write_config,
          "whether the EEPROM may be changed, which it bears seldom (9.2)");
    visit("reflectivity", self.reflectivity, "with each range; only fast models can (9.4)");
    visit("turn_period", self.turn_period, Unit("s"), Range{0.005, 0.1}, "of the mirror; 75 turns/s (9.3)");
    visit("output_delay", self.output_delay, Unit("s"), Range{0.0, 0.1},
          "from the end of a sweep's last turn to its telegram; the specification gives none");
    visit("recovery_time", self.recovery_time, Unit("s"), Range{0.1, 1000.0},
          "until a silent scanner is given up; a reset takes up to 60 s (9.2)");
    visit("quiet_time", self.quiet_time, Unit("s"), Range{0.05, 60.0},
          "without sweeps until it is asked why, and what some sweeps take");
    visit("clock", self.clock, "how times of sweeps are told from arrivals");
  }
};

/// A sweep and what the scanner said of itself with it.
struct Lms200Sweep {
  slam::LaserSweep sweep;  // pitch is 0: the scanner does not know it
  lms200::DeviceStatus status;
  int no_distance = 0;  // beams without one
};

/// What was not taken for a sweep, and how often the scanner was lost, since the driver was made.
struct Lms200Counters {
  std::uint64_t sweeps = 0;
  std::uint64_t unexpected = 0;  // another count, unit or kind than asked for
  std::uint64_t no_time = 0;     // delayed, or after a gap
  std::uint64_t incomplete = 0;  // partial sweeps without all their turns
  std::uint64_t recoveries = 0;
  lms200::LinkCounters link;
};

/// A SICK LMS-200 on a line. It finds the scanner at whatever rate it is, brings it to the options, and
/// takes sweeps, of which it believes only those whose checksum, length, count, unit and time are right.
/// When sweeps do not come any more it looks for the scanner again. Errors are sentences for who stands
/// before the robot. 721 beams (0.25 deg over 180 deg) are made of four turns that follow each other (9.2).
class Lms200 {
 public:
  Lms200(std::unique_ptr<ByteStream> line, const Lms200Options& options);

  /// Finds the scanner and sets it up. Error if it does not answer within the recovery time, or cannot be
  /// what the options ask for.
  void Connect();

  /// One sweep on request, not while streaming. Its stamp is known to one duration of a sweep.
  Lms200Sweep TakeSweep();

  /// Sweeps come by themselves until StopStream. Not all that the mirror makes if the line is too slow.
  void StartStream();
  Lms200Sweep NextSweep();
  /// The next one that arrives until `deadline`, of the line's clock [s]. None may mean that the scanner is
  /// lost: NextSweep looks for it.
  std::optional<Lms200Sweep> PollSweep(double deadline);
  void StopStream();
  bool streaming() const { return streaming_; }

  /// What the scanner says of itself.
  lms200::StatusReply AskStatus();
  std::vector<lms200::ErrorReply::Entry> AskErrors();
  const std::string& type() const { return type_; }

  /// Beams of the sweeps that are taken.
  slam::ScannerModel scanner() const;
  std::size_t beams() const { return beams_; }

  Lms200Counters counters() const;
  double Now() const { return line_->Now(); }

 private:
  struct Part {
    lms200::MeasuredValues values;
    double end;  // of its last turn [s]
  };

  // lms200_setup.cpp
  bool TrySetUp();
  bool FindBaud();
  bool AnswersAt(int baud);
  bool SwitchBaud();
  bool SetConfig();
  bool SetVariant();
  bool SetMode(const lms200::Command& command);
  void SetUpUntil(double give_up);
  std::optional<lms200::Reply> Ask(const lms200::Command& command, double reply_time = 0.3);
  lms200::Command StreamCommand() const;

  // lms200_sweeps.cpp
  bool IsExpected(const lms200::MeasuredValues& values) const;
  std::optional<Lms200Sweep> Accept(const lms200::Link::Arrived& arrived);
  std::optional<Lms200Sweep> AskForSweep();
  std::optional<Lms200Sweep> AddPart(Part part);
  Lms200Sweep SweepOf(const std::vector<Part>& parts) const;
  void PutBeams(const lms200::MeasuredValues& values, std::size_t first, std::size_t step,
                Lms200Sweep& result) const;

  void FailIfBroken(const lms200::DeviceStatus& status);
  double LongestQuiet() const;
  void Recover();
  [[noreturn]] void FailSilent() const;

  std::unique_ptr<ByteStream> line_;
  Lms200Options options_;
  lms200::Link link_;
  lms200::MeasuringMode measuring_mode_;
  lms200::LengthUnit unit_;
  lms200::Variant variant_;  // as the device is set to
  bool partial_;             // sweeps are made of four turns
  std::size_t beams_;
  bool connected_ = false;
  bool streaming_ = false;
  std::string type_;
  lms200::SweepClock clock_;
  std::vector<Part> parts_;
  Lms200Counters counters_;
};

}  // namespace ariadne::drivers
