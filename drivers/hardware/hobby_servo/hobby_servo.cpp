#include "drivers/hardware/hobby_servo/hobby_servo.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ariadne::drivers::hobby_servo {
namespace {

constexpr int kTries = 3;
constexpr double kUnitsPerMicrosecond = 4.0;

HobbyServoOptions CheckedHobbyServo(const HobbyServoOptions& options) {
  CheckOptions(options, "hobby_servo.");
  if (options.min_angle >= options.max_angle)
    Fail("hobby_servo.min_angle must be smaller than hobby_servo.max_angle");
  if (options.min_pulse >= options.max_pulse)
    Fail("hobby_servo.min_pulse must be smaller than hobby_servo.max_pulse");
  return options;
}

}  // namespace

HobbyServo::HobbyServo(std::unique_ptr<ByteStream> line, const HobbyServoOptions& options)
    : line_(std::move(line)), options_(CheckedHobbyServo(options)) {}

/// Two bytes; more or fewer are none of the controller's.
std::uint16_t HobbyServo::Ask(Code code) {
  const Bytes request = EncodeRequest({code, static_cast<std::uint8_t>(options_.channel), 0});
  const double give_up = line_->Now() + options_.recovery_time;
  for (int i = 0; i < kTries || line_->Now() < give_up; ++i) {
    if (i > 0) ++repeated_;
    line_->Read(line_->Now());
    line_->Write(request);
    const double bytes = static_cast<double>(request.size() + 2);
    const double deadline = line_->Now() + bytes * 10.0 / options_.baud + options_.reply_time;
    Bytes reply;
    while (line_->Now() < deadline && reply.size() < 2) {
      const Bytes more = line_->Read(deadline);
      reply.insert(reply.end(), more.begin(), more.end());
    }
    if (reply.size() != 2) continue;
    if (code != Code::kPosition || IsOnTheWay(NumberOf(reply))) return NumberOf(reply);
  }
  Fail("the servo controller on {} does not answer at {} baud; see its power, its cable and its rate",
       line_->name(), options_.baud);
}

/// Whether a position can be one: between the two ends of the motion, to the rounding of its steps.
bool HobbyServo::IsOnTheWay(int number) const {
  if (target_ == 0) return true;
  const int from = from_ == 0 ? target_ : from_;
  return number >= std::min(from, target_) - 1 && number <= std::max(from, target_) + 1;
}

/// An error of the line is nothing but a command that was lost; those are sent again.
void HobbyServo::FailIfFaulty() {
  const std::uint16_t errors = Ask(Code::kErrors);
  if ((errors & kScriptErrors) != 0)
    Fail("the servo controller on {} has a script that fails (errors 0x{:04X}); take it off the controller",
         line_->name(), errors);
}

void HobbyServo::Connect() {
  line_->SetBaud(options_.baud);
  line_->Write(EncodeRequest({Code::kDetectBaud, 0, 0}));
  target_ = 0;
  Ask(Code::kErrors);  // those of the time before are not ours
  FailIfFaulty();
  from_ = Ask(Code::kPosition);
}

void HobbyServo::Release() {
  line_->Write(EncodeRequest({Code::kSetTarget, static_cast<std::uint8_t>(options_.channel), 0}));
  target_ = 0;
  from_ = 0;
}

int HobbyServo::PulseNumber(double angle) const {
  const double pulse = options_.zero + (options_.reversed ? -angle : angle) * options_.per_radian;
  if (!(pulse >= options_.min_pulse && pulse <= options_.max_pulse)) {
    Fail(
        "an angle of {:.3f} rad needs a pulse of {:.0f} us, and the servo bears {} to {}; see "
        "hobby_servo.zero",
        angle, pulse, options_.min_pulse, options_.max_pulse);
  }
  return static_cast<int>(std::lround(pulse * kUnitsPerMicrosecond));
}

double HobbyServo::AngleOf(int number) const {
  const double angle = (number / kUnitsPerMicrosecond - options_.zero) / options_.per_radian;
  return options_.reversed ? -angle : angle;
}

/// At least one unit, as 0 would mean no limit.
void HobbyServo::SetProfile(double velocity, double acceleration) {
  if (!(velocity > 0.0) || !(acceleration > 0.0))
    Fail("a servo needs a velocity and an acceleration above 0");
  const double second = 1e-6 * options_.per_radian;  // of pulse per radian
  const auto number = [&](double value, double unit, int most) {
    return static_cast<int>(std::clamp<double>(std::round(value * second / unit), 1.0, most));
  };
  const auto channel = static_cast<std::uint8_t>(options_.channel);
  line_->Write(EncodeRequest({Code::kSetSpeed, channel, number(velocity, kSpeedUnit, kLargestNumber)}));
  line_->Write(
      EncodeRequest({Code::kSetAcceleration, channel, number(acceleration, kAccelerationUnit, 255)}));
}

/// Twice, as nothing acknowledges it, and a lost one would not be noticed before the end of the motion.
void HobbyServo::MoveTo(double angle) {
  if (!(angle >= options_.min_angle && angle <= options_.max_angle)) {
    Fail("the mount can be turned from {} to {} rad, not to {}", options_.min_angle, options_.max_angle,
         angle);
  }
  const int number = PulseNumber(angle);
  if (target_ != 0) from_ = Ask(Code::kPosition);
  target_ = number;
  const Bytes request =
      EncodeRequest({Code::kSetTarget, static_cast<std::uint8_t>(options_.channel), number});
  line_->Write(request);
  line_->Write(request);
}

CommandedState HobbyServo::State() {
  if (target_ == 0)
    Fail("servo {} on {} gets no pulses and may stand anywhere; move it first", options_.channel,
         line_->name());
  const double asked = line_->Now();
  const int number = Ask(Code::kPosition);
  return {0.5 * (asked + line_->Now()), AngleOf(number)};
}

void HobbyServo::WaitFor(double angle, double seconds) {
  const double give_up = line_->Now() + seconds;
  const int number = PulseNumber(angle);
  while (std::abs(Ask(Code::kPosition) - number) > 1) {
    if (line_->Now() >= give_up) {
      Fail(
          "the servo controller on {} does not send servo {} to {:.3f} rad; was it reset, or does a script "
          "move it?",
          line_->name(), options_.channel, angle);
    }
    DiscardUntil(*line_, line_->Now() + 0.02);
  }
  from_ = target_;  // from here on nothing else is believed
  DiscardUntil(*line_, line_->Now() + options_.settling);
}

}  // namespace ariadne::drivers::hobby_servo
