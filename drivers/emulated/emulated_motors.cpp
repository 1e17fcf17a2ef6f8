#include "drivers/emulated/emulated_motors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace ariadne::drivers {
namespace {

constexpr std::string_view kVersion("USB Roboclaw 2x15a v4.1.34\n\0", 28);
constexpr double kFreeCurrent = 0.4;     // of a motor that turns [A]
constexpr double kBlockedCurrent = 9.0;  // [A]
constexpr double kLoadStep = 0.01;       // [s]

std::int32_t CountOf(double pulses) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::llround(std::floor(pulses))));
}

}  // namespace

EmulatedMotors::EmulatedMotors(const EmulatedMotorsOptions& options)
    : options_(options),
      decoder_(static_cast<std::uint8_t>(options.address)),
      acceleration_(options.deceleration) {
  CheckOptions(options_, "emulated_motors.");
}

double EmulatedMotors::TimeoutEnds() const {
  return timeout_ == 0 ? std::numeric_limits<double>::infinity() : heard_ + 0.1 * timeout_;
}

/// Exactly, as accelerations are constant until a target is reached.
void EmulatedMotors::MoveFor(double seconds) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (blocked_[i]) {
      speeds_[i] = 0.0;
      continue;
    }
    const double change = targets_[i] - speeds_[i];
    const double ramp = std::min(seconds, std::abs(change) / acceleration_);
    const double after =
        ramp < seconds ? targets_[i] : speeds_[i] + std::copysign(acceleration_ * ramp, change);
    positions_[i] += 0.5 * (speeds_[i] + after) * ramp + after * (seconds - ramp);
    speeds_[i] = after;
  }
}

void EmulatedMotors::Couple() {
  if (!load_ || now_ <= rolled_until_) return;
  const std::array<double, 2> ways{positions_[0] - rolled_[0], positions_[1] - rolled_[1]};
  const double share = load_(ways, now_);
  const bool wants = targets_[0] != 0.0 || targets_[1] != 0.0;
  held_ = share < 1.0 || (held_ && wants && ways[0] == 0.0 && ways[1] == 0.0);
  if (share < 1.0) {
    for (std::size_t i = 0; i < 2; ++i) positions_[i] = rolled_[i] + share * ways[i];
    speeds_ = {};
  }
  rolled_ = positions_;
  rolled_until_ = now_;
}

/// In steps that end at multiples of their length, whenever it is asked.
void EmulatedMotors::MoveCoupled(double seconds) {
  const double end = now_ + seconds;
  while (load_ && now_ < end) {
    const double next = (std::floor(now_ / kLoadStep + 1e-6) + 1.0) * kLoadStep;
    if (next > end) break;
    MoveFor(next - now_);
    now_ = next;
    Couple();
  }
  if (end > now_) MoveFor(end - now_);
  now_ = end;
}

void EmulatedMotors::Move(double time) {
  const double stop = TimeoutEnds();
  if (stop > now_ && stop <= time) MoveCoupled(stop - now_);
  if (stop <= now_) {
    targets_ = {};
    acceleration_ = options_.deceleration;
  }
  if (time > now_) MoveCoupled(time - now_);
}

double EmulatedMotors::NextTime() const {
  if (!sendings_.empty()) return now_;
  return std::numeric_limits<double>::infinity();
}

std::vector<Sending> EmulatedMotors::Advance(double time) {
  Move(time);
  return std::exchange(sendings_, {});
}

/// Motors without power roll out at once; the encoders' counts are lost.
void EmulatedMotors::LosePower(double time, double seconds) {
  Move(time);
  ready_at_ = time + seconds;
  speeds_ = {};
  targets_ = {};
  zero_ = positions_;
  timeout_ = 0;
  decoder_.Forget();
}

void EmulatedMotors::Receive(ByteView bytes, int baud, double time) {
  if (time < ready_at_ || baud != options_.baud) return;
  const double began = time - static_cast<double>(bytes.size()) * 10.0 / baud;
  if (began - received_ >= roboclaw::kPacketPause) decoder_.Forget();
  received_ = time;
  decoder_.Push(bytes);
  while (const std::optional<roboclaw::Request> request = decoder_.Next()) Execute(*request, time);
}

void EmulatedMotors::Execute(const roboclaw::Request& request, double time) {
  heard_ = time;
  const Bytes& data = request.data;
  if (request.code == roboclaw::Code::kSetTimeout) timeout_ = data[0];
  if (request.code == roboclaw::Code::kResetEncoders) zero_ = positions_;
  std::size_t at = 0;
  if (request.code == roboclaw::Code::kSpeedsWithAcceleration) {
    acceleration_ = std::max(1.0, static_cast<double>(roboclaw::NumberAt(data, 0, 4)));
    at = 4;
  }
  if (request.code == roboclaw::Code::kSpeeds || request.code == roboclaw::Code::kSpeedsWithAcceleration) {
    for (std::size_t i = 0; i < 2; ++i) {
      targets_[i] = static_cast<std::int32_t>(roboclaw::NumberAt(data, at + 4 * i, 4));
    }
  }
  Sending sending;
  sending.start = std::max(time + options_.reply_delay, sent_until_);
  sending.byte_time = 10.0 / options_.baud;
  sending.baud = options_.baud;
  sending.bytes = roboclaw::EncodeReply(static_cast<std::uint8_t>(options_.address), request.code,
                                        DataOf(request.code));
  sent_until_ = sending.start + sending.byte_time * static_cast<double>(sending.bytes.size());
  sendings_.push_back(std::move(sending));
}

/// What a read is answered with.
Bytes EmulatedMotors::DataOf(roboclaw::Code code) const {
  Bytes data;
  if (code == roboclaw::Code::kTimeout) data = {timeout_};
  if (code == roboclaw::Code::kVersion) data.assign(kVersion.begin(), kVersion.end());
  if (code == roboclaw::Code::kBattery) {
    roboclaw::PutNumber(data, static_cast<std::uint32_t>(std::lround(options_.battery * 10.0)), 2);
  }
  if (code == roboclaw::Code::kStatus) roboclaw::PutNumber(data, status_, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    if (code == roboclaw::Code::kEncoders) {
      roboclaw::PutNumber(data, static_cast<std::uint32_t>(CountOf(positions_[i] - zero_[i])), 4);
    }
    if (code == roboclaw::Code::kMeasuredSpeeds) {
      roboclaw::PutNumber(data, static_cast<std::uint32_t>(CountOf(speeds_[i] + 0.5)), 4);
    }
    if (code == roboclaw::Code::kCurrents) {
      const bool strains = (blocked_[i] || held_) && targets_[i] != 0.0;
      const double sign = speeds_[i] > 0.0 || (strains && targets_[i] > 0.0) ? 1.0 : -1.0;
      const double amperes = strains ? kBlockedCurrent : (speeds_[i] != 0.0 ? kFreeCurrent : 0.0);
      roboclaw::PutNumber(data, static_cast<std::uint32_t>(std::lround(sign * amperes * 100.0)) & 0xFFFF,
                          2);
    }
  }
  return data;
}

}  // namespace ariadne::drivers
