#include "drivers/simulated/wheels.h"

#include <algorithm>
#include <cmath>

namespace ariadne::drivers {
namespace {

/// A speed approaches its target by a constant acceleration, and stays there.
struct Ramp {
  double speed = 0.0;  // at the end
  double way = 0.0;
};

Ramp Approach(double speed, double target, double acceleration, double duration) {
  const double excess = target - speed;
  const double accelerating = std::min(duration, std::abs(excess) / acceleration);
  const double end =
      accelerating < duration ? target : speed + std::copysign(acceleration, excess) * duration;
  return {end, 0.5 * (speed + end) * accelerating + target * (duration - accelerating)};
}

/// Counters wrap around as those of the encoders do.
std::uint32_t Count(double way, double meters_per_tick) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(way / meters_per_tick)));
}

}  // namespace

Wheels::Wheels(const control::DriveGeometry& drawing, const WheelsOptions& options, std::uint64_t seed)
    : drawing_(drawing), options_(options), slip_(NamedStream(seed, "wheels/slip")) {
  CheckOptions(drawing, "drive.");
  CheckOptions(options, "wheels.");
  RandomStream radius = NamedStream(seed, "wheels/radius"), track = NamedStream(seed, "wheels/track");
  left_scale_ = 1.0 + options.left_radius_error + DrawNormal(radius, 0.0, options.radius_spread);
  right_scale_ = 1.0 + options.right_radius_error + DrawNormal(radius, 0.0, options.radius_spread);
  true_track_ = drawing.track * (1.0 + options.track_error + DrawNormal(track, 0.0, options.track_spread));
}

void Wheels::Command(const Velocity& target) {
  if (!std::isfinite(target.forward) || !std::isfinite(target.turning)) {
    Block();
    Fail("the wheels cannot turn at {} m/s and {} rad/s", target.forward, target.turning);
  }
  const double excess = std::max({1.0, std::abs(target.forward) / options_.max_speed,
                                  std::abs(target.turning) / options_.max_turning});
  target_ = {target.forward / excess, target.turning / excess};
}

WheelStep Wheels::Accelerate(double duration) {
  const Ramp forward = Approach(velocity_.forward, target_.forward, options_.acceleration, duration);
  const Ramp turning =
      Approach(velocity_.turning, target_.turning, options_.turning_acceleration, duration);
  velocity_ = {forward.speed, turning.speed};
  return Roll(control::WheelsOf(forward.way, turning.way, drawing_.track));
}

WheelStep Wheels::Roll(const control::WheelPair& encoded) {
  WheelStep step;
  step.encoded = encoded;
  step.rolled.left = step.encoded.left * left_scale_ + Slip(step.encoded.left);
  step.rolled.right = step.encoded.right * right_scale_ + Slip(step.encoded.right);
  return step;
}

double Wheels::Slip(double way) { return DrawNormal(slip_, 0.0, options_.slip * std::sqrt(std::abs(way))); }

void Wheels::Turn(const WheelStep& step, double share) {
  encoded_.left += share * step.encoded.left;
  encoded_.right += share * step.encoded.right;
}

slam::Pose2 Wheels::Motion(const WheelStep& step, double share) const {
  return control::RollArc({share * step.rolled.left, share * step.rolled.right}, true_track_);
}

void Wheels::Block() {
  target_ = {};
  velocity_ = {};
}

control::WheelTicks Wheels::Ticks() const {
  const double meters_per_tick = drawing_.MetersPerTick();
  return {Count(encoded_.left, meters_per_tick), Count(encoded_.right, meters_per_tick)};
}

}  // namespace ariadne::drivers
