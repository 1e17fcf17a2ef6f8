#include "drivers/hardware/dynamixel/servo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace ariadne::drivers::dynamixel {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;  // [rad]
constexpr int kTries = 3;
constexpr std::uint8_t kAlert = 0x80;
constexpr std::uint8_t kPositionMode = 3;

/// What a status packet's error number means.
std::string_view NameOfError(std::uint8_t number) {
  constexpr std::array<std::string_view, 8> kNames{"no error",
                                                   "the instruction could not be carried out",
                                                   "an unknown instruction",
                                                   "a wrong checksum",
                                                   "a value out of its range",
                                                   "data of a wrong length",
                                                   "a value beyond its limit",
                                                   "a place that cannot be written now"};
  return kNames[std::min<std::size_t>(number, kNames.size() - 1)];
}

std::int32_t NumberOf(ByteView bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  return static_cast<std::int32_t>(number);
}

ServoOptions CheckedServo(const ServoOptions& options) {
  CheckOptions(options, "servo.");
  if (options.min_angle >= options.max_angle) Fail("servo.min_angle must be smaller than servo.max_angle");
  return options;
}

}  // namespace

Servo::Servo(std::unique_ptr<ByteStream> line, const ServoOptions& options)
    : line_(std::move(line)), options_(CheckedServo(options)) {}

/// A half-duplex bus may return the request as well; only a status counts.
std::optional<Packet> Servo::AskOnce(const Packet& packet) {
  const Bytes request = EncodePacket(packet);
  line_->Read(line_->Now());  // what comes late to an earlier question
  decoder_ = PacketDecoder();
  line_->Write(request);
  asked_ = line_->Now() + static_cast<double>(request.size()) * 10.0 / options_.baud;
  const double bytes = static_cast<double>(2 * request.size() + 64);
  const double deadline = line_->Now() + bytes * 10.0 / options_.baud + options_.reply_time;
  while (line_->Now() < deadline) {
    decoder_.Push(line_->Read(deadline));
    while (std::optional<Packet> reply = decoder_.Next()) {
      const bool status = reply->instruction == static_cast<std::uint8_t>(Instruction::kStatus);
      if (status && reply->id == packet.id && !reply->parameters.empty()) return reply;
    }
  }
  return std::nullopt;
}

/// The data of the answer.
Bytes Servo::Ask(const Packet& packet, std::size_t data_size) {
  const double give_up = line_->Now() + options_.recovery_time;
  for (int i = 0; i < kTries || line_->Now() < give_up; ++i) {
    if (i > 0) ++repeated_;
    const std::optional<Packet> reply = AskOnce(packet);
    if (!reply) continue;
    const std::uint8_t error = reply->parameters.front();
    const std::uint8_t number = error & 0x7F;
    if (number == 3) continue;  // the servo read it with a wrong checksum
    if (number != 0) Fail("servo {} on {} reports {}", options_.id, line_->name(), NameOfError(number));
    if (reply->parameters.size() != data_size + 1) continue;
    if ((error & kAlert) != 0 && packet.parameters.size() > 4) FailIfFaulty(error);
    return {reply->parameters.begin() + 1, reply->parameters.end()};
  }
  Fail("servo {} on {} does not answer at {} baud; see its power, its cable and its id", options_.id,
       line_->name(), options_.baud);
}

/// After something was written: reads go on, as they say what is wrong.
void Servo::FailIfFaulty(std::uint8_t) {
  const std::string error = HardwareError();
  if (!error.empty()) {
    Fail("servo {} on {} reports {}; free its mount, let it cool, and start again", options_.id,
         line_->name(), error);
  }
}

std::string Servo::HardwareError() {
  constexpr std::array<std::string_view, 6> kNames{
      "a wrong supply voltage", "", "overheating", "an encoder fault", "an electrical fault", "overload"};
  const Bytes data = Ask(
      Read(static_cast<std::uint8_t>(options_.id), static_cast<std::uint16_t>(Place::kHardwareError), 1),
      1);
  std::string text;
  for (std::size_t bit = 0; bit < kNames.size(); ++bit) {
    if ((data[0] >> bit & 1) == 0 || kNames[bit].empty()) continue;
    if (!text.empty()) text += " and ";
    text += kNames[bit];
  }
  return text;
}

void Servo::WriteByte(Place place, std::uint8_t value) {
  Ask(Write(static_cast<std::uint8_t>(options_.id), static_cast<std::uint16_t>(place), Bytes{value}), 0);
}

void Servo::WriteNumber(Place place, std::int64_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  Bytes data;
  for (int i = 0; i < 4; ++i) data.push_back(static_cast<std::uint8_t>(number >> (8 * i) & 0xFF));
  Ask(Write(static_cast<std::uint8_t>(options_.id), static_cast<std::uint16_t>(place), data), 0);
}

void Servo::Connect() {
  line_->SetBaud(options_.baud);
  const Bytes hello = Ask(Ping(static_cast<std::uint8_t>(options_.id)), 3);
  model_ = hello[0] | hello[1] << 8;
  const std::string error = HardwareError();
  if (!error.empty()) {
    Fail("servo {} on {} reports {}; switch it off, free its mount, and start again", options_.id,
         line_->name(), error);
  }
  SetTorque(false);  // the mode can be written without torque only
  WriteByte(Place::kOperatingMode, kPositionMode);
}

void Servo::SetTorque(bool enabled) { WriteByte(Place::kTorqueEnable, enabled ? 1 : 0); }

/// 0 would mean no limit.
void Servo::SetProfile(double velocity, double acceleration) {
  if (!(velocity > 0.0) || !(acceleration > 0.0))
    Fail("a servo needs a velocity and an acceleration above 0");
  const auto units = [](double value, double unit) {
    return std::clamp<std::int64_t>(std::llround(value / kTurn / unit), 1, 32767);
  };
  WriteNumber(Place::kProfileAcceleration, units(acceleration, kAccelerationUnit));
  WriteNumber(Place::kProfileVelocity, units(velocity, kVelocityUnit));
}

void Servo::MoveTo(double angle) {
  if (!(angle >= options_.min_angle && angle <= options_.max_angle)) {
    Fail("the mount can be turned from {} to {} rad, not to {}", options_.min_angle, options_.max_angle,
         angle);
  }
  const double turns = options_.zero / 360.0 + (options_.reversed ? -angle : angle) / kTurn;
  const auto steps = static_cast<std::int64_t>(std::lround(turns * kStepsPerTurn));
  if (steps < 0 || steps >= kStepsPerTurn) {
    Fail("an angle of {} rad is beyond the servo's turn; see servo.zero", angle);
  }
  WriteNumber(Place::kGoalPosition, steps);
}

ServoState Servo::State() {
  const Bytes data = Ask(
      Read(static_cast<std::uint8_t>(options_.id), static_cast<std::uint16_t>(Place::kPresentVelocity), 8),
      8);
  const double sign = options_.reversed ? -1.0 : 1.0;
  ServoState state;
  state.time = asked_;
  state.velocity = sign * NumberOf(data) * kVelocityUnit * kTurn;
  const double turns = NumberOf(ByteView(data).subspan(4)) / static_cast<double>(kStepsPerTurn);
  state.angle = sign * (turns - options_.zero / 360.0) * kTurn;
  return state;
}

void Servo::WaitFor(double angle, double tolerance, double seconds) {
  const double give_up = line_->Now() + seconds;
  while (true) {
    const ServoState state = State();
    if (std::abs(state.angle - angle) <= tolerance) return;
    if (line_->Now() >= give_up) {
      Fail("servo {} on {} stands at {:.3f} rad and not at {:.3f}; see what holds its mount", options_.id,
           line_->name(), state.angle, angle);
    }
    DiscardUntil(*line_, line_->Now() + 0.01);
  }
}

}  // namespace ariadne::drivers::dynamixel
