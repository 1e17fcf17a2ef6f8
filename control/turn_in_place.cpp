#include "control/turn_in_place.h"

#include <algorithm>
#include <cmath>

namespace ariadne::control {

double BrakingSpeed(double rest, double deceleration, double period) {
  if (!(rest > 0.0)) return 0.0;
  // speed period / 2 + speed^2 / (2 deceleration) = rest
  const double half = 0.5 * period;
  const double braking = deceleration * (std::sqrt(half * half + 2.0 * rest / deceleration) - half);
  return std::min(braking, rest / period);
}

DriveCommand TurnInPlace(double rest, const DriveCommand& before, double period,
                         const DriveLimits& limits) {
  const double speed =
      before.forward != 0.0 ? 0.0 : BrakingSpeed(std::abs(rest), limits.turning_acceleration, period);
  return Limited({0.0, std::copysign(speed, rest)}, before, period, limits);
}

bool HasTurned(double rest, double tolerance, const DriveCommand& before, double period,
               const DriveLimits& limits) {
  const bool nearly_stands = std::abs(before.turning) <= limits.turning_acceleration * period;
  return std::abs(rest) <= tolerance && nearly_stands && before.forward == 0.0;
}

}  // namespace ariadne::control
