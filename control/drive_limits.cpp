#include "control/drive_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/differential_drive.h"

namespace ariadne::control {
namespace {

struct Scales {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
};

/// By what a wanted speed can be multiplied so that it differs from the one before by no more than
/// `change`.
Scales WithinReach(double wanted, double before, double change) {
  if (wanted == 0.0) return {};
  const double a = (before - change) / wanted;
  const double b = (before + change) / wanted;
  return {std::max(0.0, std::min(a, b)), std::max(0.0, std::max(a, b))};
}

double Toward(double wanted, double before, double change) {
  return std::clamp(wanted, before - change, before + change);
}

}  // namespace

DriveCommand Saturated(const DriveCommand& wanted, const DriveLimits& limits) {
  const WheelPair wheels = WheelsOf(wanted.forward, wanted.turning, limits.track);
  const double fastest_wheel = std::max(std::abs(wheels.left), std::abs(wheels.right));
  const double excess =
      std::max({1.0, std::abs(wanted.forward) / limits.max_speed,
                std::abs(wanted.turning) / limits.max_turning, fastest_wheel / limits.max_wheel_speed});
  return {wanted.forward / excess, wanted.turning / excess};
}

DriveCommand Limited(const DriveCommand& wanted, const DriveCommand& before, double period,
                     const DriveLimits& limits) {
  const DriveCommand target = Saturated(wanted, limits);
  const double change = limits.acceleration * period;
  const double turning_change = limits.turning_acceleration * period;
  const Scales forward = WithinReach(target.forward, before.forward, change);
  const Scales turning = WithinReach(target.turning, before.turning, turning_change);
  // As fast as wanted, slower where turning cannot follow yet, and faster where the brakes are too weak.
  const double scale = std::clamp(std::min(1.0, turning.high), forward.low, forward.high);
  DriveCommand reached{Toward(scale * target.forward, before.forward, change),
                       Toward(scale * target.turning, before.turning, turning_change)};
  const double wheels_allow = 2.0 * (limits.max_wheel_speed - std::abs(reached.forward)) / limits.track;
  const double max_turning = std::clamp(wheels_allow, 0.0, limits.max_turning);
  reached.turning = std::clamp(reached.turning, -max_turning, max_turning);
  return reached;
}

}  // namespace ariadne::control
