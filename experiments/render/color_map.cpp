#include "experiments/render/color_map.h"

#include <array>
#include <cmath>

#include "experiments/render/percentile.h"

namespace ariadne::experiments {
namespace {

constexpr Rgb FromHex(unsigned hex) {
  return {static_cast<std::uint8_t>(hex >> 16U), static_cast<std::uint8_t>((hex >> 8U) & 0xFFU),
          static_cast<std::uint8_t>(hex & 0xFFU)};
}

using Knots = std::array<Rgb, 9>;

// Smooth curves through the colour space OKLab, cut into eight pieces of equal length there; between these
// knots sRGB is straight enough (steps differ by less than 10 %).
constexpr Knots kSeaKnots{FromHex(0x3d0f64), FromHex(0x3e2f84), FromHex(0x3c4e98),
                          FromHex(0x386c9e), FromHex(0x388798), FromHex(0x42a08a),
                          FromHex(0x5fb674), FromHex(0x91c758), FromHex(0xced040)};
constexpr Knots kShoreKnots{FromHex(0xe3d6be), FromHex(0xb6c9ae), FromHex(0x86baa5),
                            FromHex(0x58a8a0), FromHex(0x30929e), FromHex(0x207a9d),
                            FromHex(0x26609a), FromHex(0x304591), FromHex(0x352a7c)};
constexpr Knots kHeatKnots{FromHex(0xcdc9a7), FromHex(0xdab467), FromHex(0xe4933b),
                           FromHex(0xe2702b), FromHex(0xd44f2f), FromHex(0xbd3137),
                           FromHex(0x9f1a3e), FromHex(0x7e1141), FromHex(0x5b1443)};

// Found by farthest-point search in OKLab from five chosen colours: each next colour is as far as possible
// from all before it as seen with normal, protanopic and deuteranopic vision; lightness 0.36 to 0.70.
constexpr std::array<Rgb, kCategoricalColors> kCategorical{
    FromHex(0x1e69c3), FromHex(0xe17800), FromHex(0x5a1e78), FromHex(0x0fa587), FromHex(0xb41e1e),
    FromHex(0x8796f0), FromHex(0x006969), FromHex(0x003cb4), FromHex(0xe169c3), FromHex(0x87783c),
    FromHex(0xa52d96), FromHex(0x780f00), FromHex(0x966996), FromHex(0x006900), FromHex(0xff5a69),
    FromHex(0x7869f0), FromHex(0x3ca50f), FromHex(0x1e96c3), FromHex(0x87005a), FromHex(0xc38796)};

Rgb BetweenKnots(const Knots& knots, double share) {
  const double position = share * static_cast<double>(knots.size() - 1);
  const std::size_t lower = std::min(static_cast<std::size_t>(position), knots.size() - 2);
  return Mix(knots[lower], knots[lower + 1], position - static_cast<double>(lower));
}

}  // namespace

Rgb ColorAt(ColorMap map, double share) {
  const double inside = share > 0.0 ? std::min(share, 1.0) : 0.0;  // also where the share is NaN
  switch (map) {
    case ColorMap::kSea:
      return BetweenKnots(kSeaKnots, inside);
    case ColorMap::kShore:
      return BetweenKnots(kShoreKnots, inside);
    case ColorMap::kHeat:
      return BetweenKnots(kHeatKnots, inside);
    case ColorMap::kGray:
      break;
  }
  return Mix(FromHex(0x282828), FromHex(0xdcdcdc), inside);
}

Rgb CategoricalColor(std::size_t index) { return kCategorical[index % kCategorical.size()]; }

ValueRange RobustRange(const std::vector<double>& values, double outlier_share) {
  return {Percentile(values, outlier_share), Percentile(values, 1.0 - outlier_share)};
}

}  // namespace ariadne::experiments
