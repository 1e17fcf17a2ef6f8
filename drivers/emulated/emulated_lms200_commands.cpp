#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "drivers/emulated/emulated_lms200.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using lms200::Code;
using lms200::Command;
using lms200::Mode;

/// The rate that a mode stands for; 0 for other modes.
int BaudOfMode(Mode mode) {
  for (const int baud : lms200::kBaudRates) {
    if (lms200::ModeOfBaud(baud) == mode) return baud;
  }
  return 0;
}

bool IsRateOrPlain(Mode mode) {
  return BaudOfMode(mode) != 0 || mode == Mode::kDiagnostic || mode == Mode::kOnRequest;
}

bool IsPassword(const Bytes& data) {
  return std::equal(data.begin(), data.end(), lms200::kPassword.begin(), lms200::kPassword.end());
}

}  // namespace

void EmulatedLms200::Execute(Bytes payload, double time) {
  if (!lms200::IsCommand(payload.front())) {
    return Acknowledge(time, lms200::Notice{lms200::kUnknownCommand, status_}, options_.reply_delay);
  }
  Command command;
  try {
    command = lms200::DecodeCommand(payload);
  } catch (const Error&) {
    return Refuse(time);
  }
  switch (command.code) {
    case Code::kMode:
      return ExecuteMode(command, time);
    case Code::kVariant:
      return ExecuteVariant(command, time);
    case Code::kWriteConfig:
      return ExecuteWrite(command, time);
    case Code::kReset:
      return Acknowledge(time, lms200::Notice{lms200::kResetConfirmed, status_}, options_.reply_delay,
                         [this] { Boot(sent_until_); });
    case Code::kPermanentBaud:
      power_on_baud_ = command.permanent ? baud_ : 9600;
      return Acknowledge(time, lms200::PermanentBaudReply{true, status_}, options_.reply_delay);
    case Code::kStatus:
    case Code::kErrors:
    case Code::kType:
    case Code::kReadConfig:
      return Acknowledge(time, SimpleReply(command.code), options_.reply_delay);
    default:
      return ExecuteMeasure(command, time);
  }
}

lms200::Reply EmulatedLms200::SimpleReply(Code code) const {
  if (code == Code::kStatus) return Status();
  if (code == Code::kErrors) return lms200::ErrorReply{errors_, status_};
  if (code == Code::kReadConfig) return lms200::ConfigReply{config_, status_};
  return lms200::TypeReply{TypeText(), status_};
}

lms200::StatusReply EmulatedLms200::Status() const {
  lms200::StatusReply reply;
  reply.software = options_.s14 ? "X01.27" : "V02.10";
  reply.mode = mode_;
  reply.error = status_ & 0x07;
  reply.motor_revolutions = static_cast<std::uint16_t>(std::lround(1.0 / options_.turn_period));
  reply.measuring_mode = lms200::MeasuringModeOf(config_);
  reply.variant = variant_;
  reply.baud = baud_;
  reply.permanent_baud = power_on_baud_ != 9600;
  reply.unit = lms200::UnitOf(config_);
  reply.boot_prom = "V01.00";
  reply.status = status_;
  return reply;
}

void EmulatedLms200::ExecuteMode(const Command& command, double time) {
  const Mode mode = command.mode;
  const std::optional<Measuring> measuring = MeasuringOf(command);
  const bool allowed = mode == Mode::kInstallation
                           ? IsPassword(command.data)
                           : measuring || (IsRateOrPlain(mode) && command.data.empty());
  const auto answer = allowed ? lms200::ModeAnswer::kOk : lms200::ModeAnswer::kRefused;
  const int baud = BaudOfMode(mode);
  const auto change = [this, allowed, mode, measuring, baud] {
    if (!allowed) return;
    if (baud != 0) {  // the mode stays
      baud_ = baud;
      return;
    }
    mode_ = mode;
    measuring_ = measuring;
    mean_.clear();
    next_turn_ = 0;
  };
  const lms200::ModeReply reply{answer, status_};
  if (baud == 0 || !options_.reply_at_new_baud) {
    return Acknowledge(time, reply, options_.mode_delay, change);
  }
  time += options_.ack_delay;
  Send(time, {lms200::kAckByte}, change);
  Send(time + options_.mode_delay,
       lms200::EncodeTelegram({lms200::kFromDevice, lms200::EncodeReply(reply)}));
}

void EmulatedLms200::ExecuteVariant(const Command& command, double time) {
  const lms200::Variant wanted{command.angle, command.resolution};
  const bool mode_allows = !options_.strict || mode_ == Mode::kOnRequest || mode_ == Mode::kInstallation;
  const bool ok = lms200::Exists(wanted) && mode_allows;
  if (ok) variant_ = wanted;
  const lms200::VariantReply reply{ok, variant_.field_of_view, variant_.resolution, status_};
  Acknowledge(time, reply, options_.mode_delay);
}

void EmulatedLms200::ExecuteWrite(const Command& command, double time) {
  bool ok = !options_.strict || mode_ == Mode::kInstallation;
  try {
    const lms200::Config wanted = lms200::ConfigOf(command.data);
    ok = ok && wanted.bytes.size() == config_.bytes.size();
    if (ok) config_ = wanted;
  } catch (const Error&) {
    ok = false;
  }
  if (ok) ++config_writes_;
  Acknowledge(time, lms200::WrittenReply{ok, config_, status_}, options_.mode_delay);
}

/// What is measured after a command, none where it measures nothing, or nothing that the device can.
std::optional<EmulatedLms200::Measuring> EmulatedLms200::MeasuringOf(const Command& command) const {
  const bool is_mode = command.code == Code::kMode;
  Measuring measuring;
  measuring.left = is_mode ? -1 : 1;
  measuring.first = command.first;
  measuring.last = command.last;
  const auto is = [&](Code code, Mode mode) {
    return is_mode ? command.mode == mode : command.code == code;
  };
  const bool range =
      command.first >= 1 && command.last >= command.first && command.last <= lms200::BeamsOf(variant_);
  const bool mean = command.samples >= 2 && command.samples <= 250;
  if (mean) measuring.samples = command.samples;
  if (is_mode && command.mode == Mode::kStreamPartial) {
    measuring.partial = true;
    return measuring;
  }
  if (is_mode && command.mode == Mode::kSomePartial) {
    if (command.data.size() != 1 || command.data[0] == 0) return std::nullopt;
    measuring.partial = true;
    measuring.left = command.data[0];
    return measuring;
  }
  if (is(Code::kScan, Mode::kStream)) return measuring;
  if (is(Code::kMean, Mode::kStreamMean)) measuring.code = 0xB6;
  if (is(Code::kSubrange, Mode::kStreamSubrange)) measuring.code = 0xB7;
  if (is_mode && command.mode == Mode::kStreamFields) measuring.code = 0xB7;
  if (is(Code::kMeanSubrange, Mode::kStreamMeanSubrange)) measuring.code = 0xBF;
  if (is(Code::kReflectivity, Mode::kStreamReflectivity)) measuring.code = 0xC4;
  const bool needs_mean = measuring.code == 0xB6 || measuring.code == 0xBF;
  const bool needs_range = measuring.code != 0xB6;
  const bool fits = measuring.code != 0xC4 || (options_.s14 && lms200::BeamsOf(variant_) <= 181);
  const bool known = measuring.code != 0xB0;
  if (!known || !fits || (needs_mean && !mean) || (needs_range && !range)) return std::nullopt;
  return measuring;
}

void EmulatedLms200::ExecuteMeasure(const Command& command, double time) {
  const std::optional<Measuring> measuring = MeasuringOf(command);
  if (command.code == Code::kReflectivity && !options_.s14) {
    return Acknowledge(time, lms200::Notice{lms200::kUnknownCommand, status_}, options_.reply_delay);
  }
  if (!measuring || (options_.strict && mode_ != Mode::kOnRequest)) return Refuse(time);
  Send(time + options_.ack_delay, {lms200::kAckByte}, [this, measuring] {
    measuring_ = measuring;
    mean_.clear();
    next_turn_ = 0;
  });
}

}  // namespace ariadne::drivers
