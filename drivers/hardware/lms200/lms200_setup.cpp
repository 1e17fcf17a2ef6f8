#include <algorithm>
#include <vector>

#include "drivers/hardware/lms200/lms200.h"

namespace ariadne::drivers {
namespace {

using lms200::Code;
using lms200::CommandOf;
using lms200::Mode;

constexpr double kModeTime = 3.0;  // that a change of the mode may take (spec 9.1) [s]

}  // namespace

std::optional<lms200::Reply> Lms200::Ask(const lms200::Command& command, double reply_time) {
  const std::optional<lms200::Link::Arrived> arrived = link_.Ask(command, reply_time);
  if (!arrived) return std::nullopt;
  return arrived->reply;
}

void Lms200::Connect() {
  connected_ = true;
  SetUpUntil(line_->Now() + options_.recovery_time);
}

void Lms200::SetUpUntil(double give_up) {
  while (!TrySetUp()) {
    if (line_->Now() >= give_up) FailSilent();
    DiscardUntil(*line_, line_->Now() + 0.05);  // so that time passes on any line
  }
}

/// False where the scanner did not answer; Error where it answered that it cannot.
bool Lms200::TrySetUp() {
  if (!FindBaud()) return false;
  if (!SetMode(lms200::ModeCommand(Mode::kOnRequest)) || !SwitchBaud()) return false;
  const std::optional<lms200::Reply> type = Ask(CommandOf(Code::kType));
  if (!type) return false;
  type_ = std::get<lms200::TypeReply>(*type).type;
  if (!SetConfig() || !SetVariant()) return false;
  return !streaming_ || SetMode(StreamCommand());
}

/// Tries the rate of now, the one that is wanted, and then all others.
bool Lms200::FindBaud() {
  std::vector<int> rates = {line_->baud(), options_.baud};
  rates.insert(rates.end(), lms200::kBaudRates.begin(), lms200::kBaudRates.end());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const auto here = rates.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(rates.begin(), here, rates[i]) != here) continue;
    if (AnswersAt(rates[i])) return true;
  }
  return false;
}

bool Lms200::AnswersAt(int baud) {
  if (baud != options_.baud) {
    try {
      link_.SetBaud(baud);
    } catch (const Error&) {
      return false;  // the port has not this rate, and the scanner may have another one
    }
  } else {
    link_.SetBaud(baud);
  }
  return link_.Ask(CommandOf(Code::kStatus), 0.1, 2).has_value();
}

/// The reply may come at the old rate or at the new one: what counts is that the scanner answers there.
bool Lms200::SwitchBaud() {
  if (line_->baud() == options_.baud) return true;
  link_.Ask(lms200::ModeCommand(lms200::ModeOfBaud(options_.baud)), 0.3, 1);
  const int old = line_->baud();
  if (AnswersAt(options_.baud)) return true;
  if (AnswersAt(old)) {
    Fail("the scanner on {} stays at {} baud; lms200.baud={} needs {}", line_->name(), old, options_.baud,
         options_.baud > 38400 ? "RS-422: the bridge between pins 7 and 8, and an adapter for it"
                               : "another cable");
  }
  return false;
}

bool Lms200::SetMode(const lms200::Command& command) {
  const std::optional<lms200::Reply> reply = Ask(command, kModeTime);
  if (!reply) return false;
  if (std::get<lms200::ModeReply>(*reply).answer == lms200::ModeAnswer::kOk) return true;
  Fail("the scanner on {} ({}) refuses mode 0x{:02X}", line_->name(), type_,
       static_cast<int>(command.mode));
}

/// Unit and measuring mode are in the EEPROM, which is written only if that is allowed.
bool Lms200::SetConfig() {
  const std::optional<lms200::Reply> reply = Ask(CommandOf(Code::kReadConfig));
  if (!reply) return false;
  const lms200::Config& now = std::get<lms200::ConfigReply>(*reply).config;
  const lms200::Config wanted = lms200::WithUnit(lms200::WithMeasuringMode(now, measuring_mode_), unit_);
  if (wanted == now) return true;
  if (!options_.write_config) {
    Fail(
        "the scanner on {} is configured for mode 0x{:02X} in {}, not for mode 0x{:02X} in {}; "
        "lms200.write_config=true lets this program change it",
        line_->name(), static_cast<int>(lms200::MeasuringModeOf(now)),
        lms200::UnitOf(now) == lms200::LengthUnit::kMillimetre ? "mm" : "cm",
        static_cast<int>(measuring_mode_), options_.millimetres ? "mm" : "cm");
  }
  if (!SetMode(lms200::PasswordCommand())) return false;
  lms200::Command write = CommandOf(Code::kWriteConfig);
  write.data = wanted.bytes;
  const std::optional<lms200::Reply> written = Ask(write, kModeTime);
  if (!written) return false;
  const auto& echo = std::get<lms200::WrittenReply>(*written);
  if (!echo.ok || echo.config != wanted)
    Fail("the scanner on {} did not take its configuration", line_->name());
  return SetMode(lms200::ModeCommand(Mode::kOnRequest));
}

bool Lms200::SetVariant() {
  const std::optional<lms200::Reply> reply = Ask(lms200::VariantCommand(variant_), kModeTime);
  if (!reply) return false;
  const auto& variant = std::get<lms200::VariantReply>(*reply);
  if (variant.ok && lms200::Variant{variant.angle, variant.resolution} == variant_) return true;
  Fail("the scanner on {} ({}) cannot measure {} deg in steps of {} deg", line_->name(), type_,
       options_.field_of_view, options_.resolution);
}

lms200::Command Lms200::StreamCommand() const {
  if (!options_.reflectivity) {
    return lms200::ModeCommand(partial_ ? Mode::kStreamPartial : Mode::kStream);
  }
  lms200::Command command = lms200::ModeCommand(Mode::kStreamReflectivity);
  command.first = 1;
  command.last = static_cast<std::uint16_t>(beams_);
  return command;
}

void Lms200::StartStream() {
  if (!connected_) Connect();
  clock_.Reset();
  parts_.clear();
  streaming_ = true;
  if (!SetMode(StreamCommand())) Recover();
}

void Lms200::StopStream() {
  streaming_ = false;
  parts_.clear();
  if (!SetMode(lms200::ModeCommand(Mode::kOnRequest))) Recover();
}

lms200::StatusReply Lms200::AskStatus() {
  const std::optional<lms200::Reply> reply = Ask(CommandOf(Code::kStatus));
  if (!reply)
    Fail("the scanner on {} does not tell its status; see its power and its cable", line_->name());
  return std::get<lms200::StatusReply>(*reply);
}

std::vector<lms200::ErrorReply::Entry> Lms200::AskErrors() {
  const std::optional<lms200::Reply> reply = Ask(CommandOf(Code::kErrors));
  return reply ? std::get<lms200::ErrorReply>(*reply).entries : std::vector<lms200::ErrorReply::Entry>{};
}

}  // namespace ariadne::drivers
