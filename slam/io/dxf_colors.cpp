#include "slam/io/dxf_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::slam {
namespace {

constexpr int kForeground = 7;
constexpr int kFirstOfWheel = 10;  // 24 hues, ten shades of each
constexpr int kFirstGray = 250;

constexpr std::array<Rgb, 10> kNamed{{{0, 0, 0},
                                      {255, 0, 0},
                                      {255, 255, 0},
                                      {0, 255, 0},
                                      {0, 255, 255},
                                      {0, 0, 255},
                                      {255, 0, 255},
                                      {255, 255, 255},
                                      {128, 128, 128},
                                      {192, 192, 192}}};
constexpr std::array<std::uint8_t, 6> kGrays{51, 80, 105, 130, 190, 255};

/// The share of a channel (0 red, 1 green, 2 blue) in a pure hue, which is counted in steps of 15 deg.
double ShareInHue(int hue_step, int channel) {
  const double sixths = std::fmod(hue_step / 4.0 + 6.0 - 2.0 * channel, 6.0);  // from the channel's own hue
  return std::clamp(2.0 - std::min(sixths, 6.0 - sixths), 0.0, 1.0);
}

/// Of a shade: even ones are full, odd ones half mixed with white; both get darker in pairs.
Rgb ColorOfWheel(int number) {
  constexpr std::array<double, 5> kValues{1.0, 0.65, 0.5, 0.3, 0.15};
  const int hue_step = (number - kFirstOfWheel) / 10, shade = number % 10;
  const auto channel = [&](int which) {
    const double share = ShareInHue(hue_step, which);
    const double mixed = shade % 2 == 0 ? share : 0.5 * (1.0 + share);
    return static_cast<std::uint8_t>(255.0 * kValues[static_cast<std::size_t>(shade) / 2] * mixed);
  };
  return {channel(0), channel(1), channel(2)};
}

int SquaredDistance(const Rgb& a, const Rgb& b) {
  const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

}  // namespace

Rgb ColorOfAci(int number) {
  if (number < kFirstOfWheel) return kNamed[static_cast<std::size_t>(number)];
  if (number < kFirstGray) return ColorOfWheel(number);
  const std::uint8_t gray = kGrays[static_cast<std::size_t>(number - kFirstGray)];
  return {gray, gray, gray};
}

int NearestAci(const Rgb& color) {
  int nearest = kForeground;
  int least = std::min(SquaredDistance(color, {0, 0, 0}), SquaredDistance(color, {255, 255, 255}));
  for (int number = 1; number <= 255; ++number) {
    const int distance = SquaredDistance(color, ColorOfAci(number));
    if (distance >= least) continue;
    least = distance;
    nearest = number;
  }
  return nearest;
}

}  // namespace ariadne::slam
