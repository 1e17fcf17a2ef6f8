#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "slam/geometry/rgb.h"

namespace ariadne::experiments {

using slam::Rgb;

inline constexpr Rgb kWhite{255, 255, 255};
inline constexpr Rgb kBlack{0, 0, 0};

/// A channel value in 0 to 255, rounded, as 8 bits.
inline std::uint8_t ToChannel(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// The colour at share s of the way from a (s = 0) to b (s = 1).
inline Rgb Mix(Rgb a, Rgb b, double s) {
  const auto mix = [s](double from, double to) { return ToChannel(from + (to - from) * s); };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace ariadne::experiments
