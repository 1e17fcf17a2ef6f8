#include "drivers/hardware/roboclaw/motors.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "drivers/hardware/roboclaw/find_reply.h"

namespace ariadne::drivers::roboclaw {
namespace {

constexpr double kQuickest = 1e9;   // acceleration of a stop [pulses/s^2]
constexpr double kStaleTime = 0.1;  // after which wheels must not turn on what was said before [s]
constexpr std::size_t kMostLate = 16;

MotorsOptions CheckedMotors(const MotorsOptions& options) {
  CheckOptions(options, "motors.");
  return options;
}

std::int32_t SignedAt(ByteView bytes, std::size_t at) {
  return static_cast<std::int32_t>(NumberAt(bytes, at, 4));
}

/// Zero speeds, as quickly as the board can.
Bytes HaltData() {
  Bytes data;
  PutNumber(data, static_cast<std::uint32_t>(kQuickest), 4);
  data.resize(DataSize(Code::kSpeedsWithAcceleration));
  return data;
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

/// The board forgets half a packet.
void Motors::Pause() {
  ++repeated_;
  DiscardUntil(*line_, line_->Now() + kPacketPause);
}

/// An acknowledgement is one byte, with which a late reply may begin as well.
bool Motors::IsDoubtful(Code code) const {
  return IsWrite(code) && std::any_of(late_.begin(), late_.end(), [](Code late) { return !IsWrite(late); });
}

/// What was taken for the answer may be that of an earlier request of this kind; then another one comes.
void Motors::Answered(Code code) {
  const bool twice = std::any_of(late_.begin(), late_.end(), [code](Code late) {
    return late == code || (IsWrite(late) && IsWrite(code));
  });
  late_.clear();
  if (twice) late_.push_back(code);
}

/// The data of the answer, none until `deadline`.
std::optional<Bytes> Motors::Exchange(Code code, const Bytes& request, double deadline) {
  line_->Read(line_->Now());
  line_->Write(request);
  asked_ = line_->Now() + static_cast<double>(request.size()) * 10.0 / options_.baud;
  Bytes bytes;
  FoundReply found;
  for (double until = deadline; line_->Now() < until && found.can_come;) {
    const Bytes more = line_->Read(until);
    bytes.insert(bytes.end(), more.begin(), more.end());
    found = FindReply(AddressOf(options_), code, bytes, late_);
    if (found.data && !IsDoubtful(code)) break;
    until = found.data ? std::min(deadline, line_->Now() + kPacketPause) : deadline;
    if (found.data && more.empty()) break;
  }
  if (found.data) {
    Answered(code);
  } else {
    late_.push_back(code);
    if (late_.size() > kMostLate) late_.erase(late_.begin());
  }
  return found.data;
}

/// Zero speed, of which nobody waits to hear.
void Motors::HaltUnheard() {
  line_->Write(EncodeRequest(AddressOf(options_), Code::kSpeedsWithAcceleration, HaltData()));
  late_.push_back(Code::kSpeedsWithAcceleration);
  turning_ = false;
  halting_ = true;
}

/// Wheels that turn must not do so for long on a command whose effect nobody sees, and each question puts
/// off the board's own timeout.
std::optional<Bytes> Motors::TryAsk(Code code, double give_up) {
  const double stale = line_->Now() + kStaleTime;
  const Bytes request = EncodeRequest(AddressOf(options_), code);
  const std::size_t size =
      request.size() + DataSize(code) + (code == Code::kVersion ? kLongestVersion : 0) + 2;
  for (int i = 0; i == 0 || line_->Now() < give_up; ++i) {
    if (i > 0 && (halting_ || (turning_ && line_->Now() + kPacketPause >= stale))) HaltUnheard();
    if (i > 0) Pause();
    const double deadline = turning_ ? std::min(Deadline(size), stale) : Deadline(size);
    std::optional<Bytes> data = Exchange(code, request, deadline);
    if (!data) continue;
    if (std::exchange(halting_, false)) Tell(Code::kSpeedsWithAcceleration, HaltData());
    return data;
  }
  return std::nullopt;
}

/// Commands may come twice, since all of them set something.
bool Motors::TryTell(Code code, const Bytes& data, double give_up) {
  const Bytes request = EncodeRequest(AddressOf(options_), code, data);
  for (int i = 0; i == 0 || line_->Now() < give_up; ++i) {
    if (i > 0) Pause();
    const double deadline = Deadline(request.size() + 1);
    if (Exchange(code, request, i == 0 ? deadline : std::min(deadline, give_up))) return true;
  }
  return false;
}

Bytes Motors::Ask(Code code) {
  std::optional<Bytes> data = TryAsk(code, GiveUp());
  if (!data) FailSilent();
  return *std::move(data);
}

void Motors::Tell(Code code, const Bytes& data) {
  if (!TryTell(code, data, GiveUp())) FailSilent();
}

std::uint8_t Motors::TimeoutNumber() const {
  return static_cast<std::uint8_t>(std::lround(options_.timeout * 10.0));
}

/// False where it does not answer in time.
bool Motors::TryFailIfRestarted(double give_up) {
  const std::optional<Bytes> timeout = TryAsk(Code::kTimeout, give_up);
  if (!timeout) return false;
  if (timeout->front() == TimeoutNumber()) return true;
  Tell(Code::kSetTimeout, {TimeoutNumber()});
  Fail(
      "the motor board on {} was without power for a moment and has lost its counts; see its battery and "
      "its plug",
      line_->name());
}

void Motors::FailIfRestarted() {
  if (!TryFailIfRestarted(GiveUp())) FailSilent();
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

bool Motors::SetSpeeds(const Pair& speeds, double acceleration) {
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
  if (speeds[0] != 0.0 || speeds[1] != 0.0) return Turn(data);
  Tell(Code::kSpeedsWithAcceleration, data);
  turning_ = halting_ = false;
  FailIfRestarted();
  return true;
}

/// What was decided on what is seen must not be done much later.
bool Motors::Turn(const Bytes& data) {
  const double give_up = std::min(GiveUp(), line_->Now() + kStaleTime);
  bool told = TryFailIfRestarted(give_up);
  if (told) {
    turning_ = true;  // perhaps, also where the answer is lost
    told = TryTell(Code::kSpeedsWithAcceleration, data, give_up);
  }
  if (!told) Stop();
  return told;
}

void Motors::Stop() { SetSpeeds({0.0, 0.0}, kQuickest); }

EncoderCounts Motors::Encoders() {
  line_->Read(line_->Now());  // a recorded line knows the time of its last call only
  const Bytes data = Ask(Code::kEncoders);
  const EncoderCounts counts{asked_, {SignedAt(data, 0), SignedAt(data, 4)}};
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
