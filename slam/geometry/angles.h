#pragma once

#include <cmath>
#include <numbers>

namespace ariadne::slam {

constexpr double RadFromDeg(double deg) { return deg * (std::numbers::pi / 180.0); }
constexpr double DegFromRad(double rad) { return rad * (180.0 / std::numbers::pi); }

/// The same angle in (-pi, pi].
inline double WrapAngle(double rad) {
  const double wrapped = std::remainder(rad, 2.0 * std::numbers::pi);  // [-pi, pi]
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

}  // namespace ariadne::slam
