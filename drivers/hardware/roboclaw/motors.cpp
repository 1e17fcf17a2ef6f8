#include "drivers/hardware/roboclaw/motors.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace ariadne::drivers::roboclaw {
namespace {

constexpr int kTries = 3;
constexpr double kQuickest = 1e9;  // acceleration of a stop [pulses/s^2]

MotorsOptions CheckedMotors(const MotorsOptions& options) {
  CheckOptions(options, "motors.");
  return options;
}

std::int32_t SignedAt(ByteView bytes, std::size_t at) {
  return static_cast<std::int32_t>(NumberAt(bytes, at, 4));
}

std::uint8_t AddressOf(const MotorsOptions& options) { return static_cast<std::uint8_t>(options.address); }

}  // namespace

std::int32_t CountsBetween(std::int32_t before, std::int32_t after) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(after) - static_cast<std::uint32_t>(before));
}

Motors::Motors(std::unique_ptr<ByteStream> line, const MotorsOptions& options)
    : line_(std::move(line)), options_(CheckedMotors(options)) {}

void Motors::FailSilent() const {
  Fail("the motor board on {} does not answer at {} baud, address {}; see its power and its cable",
       line_->name(), options_.baud, options_.address);
}

double Motors::Deadline(std::size_t bytes) const {
  return line_->Now() + static_cast<double>(bytes) * 10.0 / options_.baud + options_.reply_time;
}

/// Replies have no beginning either: what is left of an earlier one is thrown away before a question.
Bytes Motors::Ask(Code code) {
  const double give_up = line_->Now() + options_.recovery_time;
  for (int i = 0; i < kTries || line_->Now() < give_up; ++i) {
    if (i > 0) {
      ++repeated_;
      DiscardUntil(*line_, line_->Now() + kPacketPause);  // so that the board forgets half a packet
    }
    line_->Read(line_->Now());
    line_->Write(EncodeRequest(AddressOf(options_), code));
    const double deadline =
        Deadline(2 + DataSize(code) + (code == Code::kVersion ? kLongestVersion : 0) + 2);
    Bytes reply;
    try {
      while (line_->Now() < deadline) {
        const Bytes more = line_->Read(deadline);
        reply.insert(reply.end(), more.begin(), more.end());
        if (const std::optional<Bytes> data = DecodeReply(AddressOf(options_), code, reply)) return *data;
      }
    } catch (const Error&) {
      if (reply.empty()) throw;  // of the line, not of the reply
    }
  }
  FailSilent();
}

/// Commands may come twice, since all of them set something.
void Motors::Tell(Code code, const Bytes& data) {
  const double give_up = line_->Now() + std::min(options_.recovery_time, options_.timeout);
  for (int i = 0; i < kTries || line_->Now() < give_up; ++i) {
    if (i > 0) {
      ++repeated_;
      DiscardUntil(*line_, line_->Now() + kPacketPause);
    }
    line_->Read(line_->Now());
    const Bytes request = EncodeRequest(AddressOf(options_), code, data);
    line_->Write(request);
    if (line_->Read(Deadline(request.size() + 1)) == Bytes{kAcknowledged}) return;
  }
  FailSilent();
}

std::uint8_t Motors::TimeoutNumber() const {
  return static_cast<std::uint8_t>(std::lround(options_.timeout * 10.0));
}

void Motors::FailIfRestarted() {
  if (Ask(Code::kTimeout).front() == TimeoutNumber()) return;
  Tell(Code::kSetTimeout, {TimeoutNumber()});
  Fail(
      "the motor board on {} was without power for a moment and has lost its counts; see its battery and "
      "its plug",
      line_->name());
}

void Motors::Connect() {
  line_->SetBaud(options_.baud);
  const Bytes version = Ask(Code::kVersion);
  version_.assign(version.begin(), std::find(version.begin(), version.end(), std::uint8_t{'\n'}));
  Tell(Code::kSetTimeout, {TimeoutNumber()});
  if (Ask(Code::kTimeout).front() != TimeoutNumber()) {
    Fail("the motor board on {} does not keep its timeout of {} s; do not drive it", line_->name(),
         options_.timeout);
  }
  Stop();
}

void Motors::SetSpeeds(const Pair& speeds, double acceleration) {
  Bytes data;
  if (!(acceleration > 0.0)) Fail("motors need an acceleration above 0, not {}", acceleration);
  PutNumber(data, static_cast<std::uint32_t>(std::llround(std::min(acceleration, kQuickest))), 4);
  for (const double speed : speeds) {
    if (!(std::abs(speed) <= options_.max_speed)) {
      Fail("motors may turn with up to {} pulses/s, not with {}; see motors.max_speed", options_.max_speed,
           speed);
    }
    PutNumber(data, static_cast<std::uint32_t>(std::llround(speed)), 4);
  }
  FailIfRestarted();
  Tell(Code::kSpeedsWithAcceleration, data);
}

void Motors::Stop() { SetSpeeds({0.0, 0.0}, kQuickest); }

EncoderCounts Motors::Encoders() {
  line_->Read(line_->Now());  // a recorded line knows the time of its last call only
  const double asked = line_->Now();
  const Bytes data = Ask(Code::kEncoders);
  const EncoderCounts counts{0.5 * (asked + line_->Now()), {SignedAt(data, 0), SignedAt(data, 4)}};
  FailIfRestarted();
  return counts;
}

Pair Motors::MeasuredSpeeds() {
  const Bytes data = Ask(Code::kMeasuredSpeeds);
  return {static_cast<double>(SignedAt(data, 0)), static_cast<double>(SignedAt(data, 4))};
}

Pair Motors::Currents() {
  const Bytes data = Ask(Code::kCurrents);
  const auto amperes = [&](std::size_t at) {
    return static_cast<std::int16_t>(NumberAt(data, at, 2)) * 0.01;
  };
  return {amperes(0), amperes(2)};
}

double Motors::Battery() { return NumberAt(Ask(Code::kBattery), 0, 2) * 0.1; }

std::string Motors::Warnings() {
  constexpr std::array<std::string_view, 14> kNames{"overcurrent of motor 1",
                                                    "overcurrent of motor 2",
                                                    "emergency stop",
                                                    "overheating",
                                                    "overheating (2)",
                                                    "main battery too high",
                                                    "logic battery too high",
                                                    "logic battery too low",
                                                    "driver fault of motor 1",
                                                    "driver fault of motor 2",
                                                    "main battery rather high",
                                                    "main battery rather low",
                                                    "warm",
                                                    "warm (2)"};
  const std::uint32_t bits = NumberAt(Ask(Code::kStatus), 0, 2);
  std::string text;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if ((bits >> i & 1) == 0) continue;
    if (!text.empty()) text += ", ";
    text += kNames[i];
  }
  return text;
}

}  // namespace ariadne::drivers::roboclaw
