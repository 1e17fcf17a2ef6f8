#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ariadne::experiments {

/// A colour as it stands in a picture: sRGB, 8 bits per channel.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

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
