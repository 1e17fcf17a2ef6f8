#include "drivers/hardware/lms200/lms200.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ariadne::drivers {
namespace {

lms200::Variant VariantOf(const Lms200Options& options, bool partial) {
  lms200::Variant variant;
  variant.field_of_view = static_cast<std::uint16_t>(options.field_of_view);
  variant.resolution = static_cast<std::uint16_t>(partial ? 100 : std::lround(options.resolution * 100.0));
  if (!lms200::Exists(variant) || (!partial && options.resolution * 100.0 != variant.resolution)) {
    Fail("the LMS-200 cannot measure {} deg in steps of {} deg; it has 100 or 180, and 1, 0.5 or 0.25",
         options.field_of_view, options.resolution);
  }
  return variant;
}

bool IsPartial(const Lms200Options& options) {
  return options.field_of_view == 180 && options.resolution == 0.25;
}

Lms200Options Checked(const Lms200Options& options) {
  CheckOptions(options, "lms200.");
  lms200::ModeOfBaud(options.baud);
  if (IsPartial(options) && options.baud != 500000) {
    Fail(
        "0.25 deg over 180 deg needs lms200.baud=500000: a slower line cannot carry each turn of the "
        "mirror");
  }
  if (options.reflectivity && (options.field_of_view != 180 || options.resolution != 1.0)) {
    Fail("lms200.reflectivity needs 180 deg in steps of 1 deg, as more does not fit in a telegram");
  }
  return options;
}

}  // namespace

Lms200::Lms200(std::unique_ptr<ByteStream> line, const Lms200Options& options)
    : line_(std::move(line)),
      options_(Checked(options)),
      link_(*line_),
      measuring_mode_(lms200::MeasuringModeOf(static_cast<std::uint8_t>(options.measuring_mode))),
      unit_(options.millimetres ? lms200::LengthUnit::kMillimetre : lms200::LengthUnit::kCentimetre),
      variant_(VariantOf(options, IsPartial(options))),
      partial_(IsPartial(options)),
      beams_(partial_ ? 721 : lms200::BeamsOf(variant_)),
      clock_(options.turn_period * (partial_ ? 1 : lms200::TurnsOf(variant_)), options.clock) {}

slam::ScannerModel Lms200::scanner() const {
  constexpr double kRadians = std::numbers::pi / 180.0;
  slam::ScannerModel scanner;
  scanner.first_angle = (options_.field_of_view == 100 ? 40.0 : 0.0) * kRadians;
  scanner.angle_step = options_.resolution * kRadians;
  scanner.turns_per_sweep = partial_ ? lms200::kTurnsOfPartial : lms200::TurnsOf(variant_);
  scanner.turn_period = options_.turn_period;
  return scanner;
}

Lms200Counters Lms200::counters() const {
  Lms200Counters counters = counters_;
  counters.link = link_.counters();
  return counters;
}

void Lms200::FailSilent() const {
  Fail("the scanner on {} has sent no sweep for {} s; see its power and its cable, and start again",
       line_->name(), options_.recovery_time);
}

void Lms200::FailIfBroken(const lms200::DeviceStatus& status) {
  if (status.severity < 3) return;
  std::string memory;
  for (const lms200::ErrorReply::Entry& entry : AskErrors()) {
    memory += fmt::format(" {}/{}", entry.type, entry.number);
  }
  Fail(
      "the scanner on {} reports {} (error memory, type/number:{}); switch it off and on, or see its "
      "manual",
      line_->name(), status.severity == 3 ? "an error" : "a fatal error",
      memory.empty() ? " empty" : memory);
}

/// How long sweeps may stay away: some are needed before there are times again.
double Lms200::LongestQuiet() const {
  constexpr double kSweeps = 6.0;
  const double sweep = options_.turn_period * lms200::TurnsOf(variant_);
  return options_.quiet_time + kSweeps * std::max(sweep, link_.TimeOf(lms200::kFrameSize + 2 * beams_));
}

Lms200Sweep Lms200::NextSweep() {
  if (!streaming_) Fail("the scanner on {} is not streaming", line_->name());
  const double give_up = line_->Now() + options_.recovery_time;
  double quiet_until = line_->Now() + LongestQuiet();
  while (true) {
    const std::optional<lms200::Link::Arrived> arrived = link_.NextReply(quiet_until);
    const bool booted = arrived && std::holds_alternative<lms200::PowerOn>(arrived->reply);
    if (!arrived || booted || line_->Now() >= quiet_until) {
      if (line_->Now() >= give_up) FailSilent();
      Recover();
      quiet_until = line_->Now() + LongestQuiet();
      continue;
    }
    if (std::optional<Lms200Sweep> sweep = Accept(*arrived)) {
      ++counters_.sweeps;
      return std::move(*sweep);
    }
  }
}

std::optional<Lms200Sweep> Lms200::PollSweep(double deadline) {
  if (!streaming_) Fail("the scanner on {} is not streaming", line_->name());
  while (const std::optional<lms200::Link::Arrived> arrived = link_.NextReply(deadline)) {
    if (std::optional<Lms200Sweep> sweep = Accept(*arrived)) {
      ++counters_.sweeps;
      return sweep;
    }
  }
  return std::nullopt;
}

/// Sweeps have not come for a while, or the scanner has booted.
void Lms200::Recover() {
  ++counters_.recoveries;
  clock_.Reset();
  parts_.clear();
  SetUpUntil(line_->Now() + options_.recovery_time);
}

Lms200Sweep Lms200::TakeSweep() {
  if (!connected_ || streaming_) Fail("the scanner on {} does not wait for requests", line_->name());
  if (partial_ || options_.reflectivity) {
    StartStream();
    Lms200Sweep sweep = NextSweep();
    StopStream();
    return sweep;
  }
  const double give_up = line_->Now() + options_.recovery_time;
  while (line_->Now() < give_up) {
    if (std::optional<Lms200Sweep> sweep = AskForSweep()) {
      ++counters_.sweeps;
      return std::move(*sweep);
    }
    if (!link_.Ask(lms200::CommandOf(lms200::Code::kStatus), 0.1, 2)) Recover();
  }
  FailSilent();
}

/// The sweep ends at most its duration after the ACK; what comes later was delayed, nobody knows for how
/// long.
std::optional<Lms200Sweep> Lms200::AskForSweep() {
  constexpr double kSlack = 0.005;  // [s]
  const double duration = options_.turn_period * lms200::TurnsOf(variant_);
  const auto arrived = link_.Ask(lms200::CommandOf(lms200::Code::kScan), duration + 0.05, 1);
  const auto* values = arrived ? std::get_if<lms200::MeasuredValues>(&arrived->reply) : nullptr;
  if (values == nullptr) return std::nullopt;
  const lms200::DeviceStatus status = lms200::DeviceStatusOf(values->status);
  FailIfBroken(status);
  const double end = arrived->time - link_.TimeOf(arrived->size);
  const bool in_time = end <= arrived->asked + link_.UsualAck() + duration + kSlack;
  const bool expected = IsExpected(*values) && !status.restart;
  if (!expected) ++counters_.unexpected;
  if (!in_time) ++counters_.no_time;
  if (!expected || !in_time) return std::nullopt;
  return SweepOf({Part{*values, end - options_.output_delay}});
}

}  // namespace ariadne::drivers
