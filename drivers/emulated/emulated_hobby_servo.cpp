#include "drivers/emulated/emulated_hobby_servo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ariadne::drivers {
namespace {

constexpr double kPulseStep = 0.01;  // from one pulse length to the next [s]
constexpr double kMicrosecond = 1e-6;
constexpr double kQuarter = 0.25;  // [us]
constexpr std::uint16_t kProtocolError = 0x0010;

}  // namespace

EmulatedHobbyServo::EmulatedHobbyServo(const EmulatedHobbyServoOptions& options)
    : options_(options), position_(options.pulse) {
  CheckOptions(options_, "emulated_hobby_servo.");
}

void EmulatedHobbyServo::SwitchOn() {
  pulse_ = rate_ = target_ = speed_ = acceleration_ = 0.0;
  errors_ = 0;
  decoder_ = {};
  bad_ = 0;
}

/// The pulse goes towards its target by speed and acceleration.
void EmulatedHobbyServo::StepPulse() {
  const double left = target_ - pulse_;
  const double brake = acceleration_ > 0.0 ? std::sqrt(2.0 * acceleration_ * std::abs(left)) : 1e9;
  const double fastest = speed_ > 0.0 ? speed_ : 1e9;
  const double wanted = std::copysign(std::min(fastest, brake), left);
  const double most = acceleration_ > 0.0 ? acceleration_ * kPulseStep : 1e9;
  rate_ += std::clamp(wanted - rate_, -most, most);
  if (std::abs(left) <= std::abs(rate_) * kPulseStep + 0.5 * kQuarter) {
    pulse_ = target_;
    rate_ = 0.0;
  } else {
    pulse_ += rate_ * kPulseStep;
  }
}

void EmulatedHobbyServo::Move(double time) {
  while (now_ < time) {
    const double end = std::min(next_step_, time);
    const double seconds = end - now_;
    if (pulse_ > 0.0 && !stuck_ && seconds > 0.0) {
      const double wanted =
          (pulse_ - position_) * (options_.lag > 0.0 ? 1.0 - std::exp(-seconds / options_.lag) : 1.0);
      position_ += std::clamp(wanted, -options_.fastest * seconds, options_.fastest * seconds);
    }
    now_ = end;
    memory_.Remember(now_, position_);
    if (now_ < next_step_) continue;
    next_step_ += kPulseStep;
    if (target_ > 0.0) StepPulse();
  }
}

double EmulatedHobbyServo::NextTime() const {
  return sendings_.empty() ? std::numeric_limits<double>::infinity() : now_;
}

std::vector<Sending> EmulatedHobbyServo::Advance(double time) {
  if (time >= ready_at_) Move(time);
  return std::exchange(sendings_, {});
}

void EmulatedHobbyServo::LosePower(double time, double seconds) {
  Move(time);
  ready_at_ = time + seconds;
  now_ = next_step_ = ready_at_;
  SwitchOn();
}

void EmulatedHobbyServo::Receive(ByteView bytes, int baud, double time) {
  if (time < ready_at_ || baud != options_.baud) return;
  decoder_.Push(bytes);
  while (const std::optional<hobby_servo::Request> request = decoder_.Next()) Execute(*request, time);
  if (decoder_.bad() > bad_) errors_ |= kProtocolError;
  bad_ = decoder_.bad();
}

void EmulatedHobbyServo::Reply(std::uint16_t number, double time) {
  const double byte_time = 10.0 / options_.baud;
  const double start = std::max(time + options_.reply_delay, sent_until_);
  sendings_.push_back({start,
                       byte_time,
                       options_.baud,
                       {static_cast<std::uint8_t>(number & 0xFF), static_cast<std::uint8_t>(number >> 8)}});
  sent_until_ = start + 2.0 * byte_time;
}

void EmulatedHobbyServo::Execute(const hobby_servo::Request& request, double time) {
  using hobby_servo::Code;
  if (request.code == Code::kErrors) return Reply(std::exchange(errors_, std::uint16_t{0}), time);
  if (request.code == Code::kDetectBaud) return;
  const bool mine = request.channel == options_.channel;
  if (request.code == Code::kPosition)
    return Reply(mine ? static_cast<std::uint16_t>(std::lround(pulse_ / kQuarter)) : std::uint16_t{0},
                 time);
  if (!mine) return;
  if (request.code == Code::kSetSpeed) speed_ = request.number * hobby_servo::kSpeedUnit / kMicrosecond;
  if (request.code == Code::kSetAcceleration)
    acceleration_ = request.number * hobby_servo::kAccelerationUnit / kMicrosecond;
  if (request.code != Code::kSetTarget) return;
  target_ = request.number * kQuarter;
  if (target_ == 0.0 || pulse_ == 0.0) {
    pulse_ = target_;
    rate_ = 0.0;
  }
}

}  // namespace ariadne::drivers
