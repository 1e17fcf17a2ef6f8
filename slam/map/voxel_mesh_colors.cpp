#include "slam/map/voxel_mesh_colors.h"

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

/// Where the values lie between two of their quantiles, from 0 to 1; NaN stays NaN.
std::vector<double> Shares(std::span<const double> values, double low_quantile, double high_quantile) {
  std::vector<double> sorted(values.begin(), values.end());
  std::erase_if(sorted, [](double value) { return !std::isfinite(value); });
  std::ranges::sort(sorted);
  const auto quantile = [&](double share) {
    return sorted.empty() ? 0.0
                          : sorted[static_cast<std::size_t>(
                                std::lround(share * static_cast<double>(sorted.size() - 1)))];
  };
  const double low = quantile(low_quantile);
  const double width = quantile(high_quantile) - low;
  std::vector<double> shares;
  for (const double value : values) {
    shares.push_back(width > 0.0 ? std::clamp((value - low) / width, 0.0, 1.0) : 0.5 + 0.0 * value);
  }
  return shares;
}

std::uint8_t Byte(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

std::vector<Rgb> GreyColors(std::span<const double> values) {
  std::vector<Rgb> colors;
  for (const double share : Shares(values, 0.02, 0.98)) {
    const std::uint8_t grey = Byte(std::isfinite(share) ? share : 0.5);
    colors.push_back({grey, grey, grey});
  }
  return colors;
}

std::vector<Rgb> RainbowColors(std::span<const double> values) {
  std::vector<Rgb> colors;
  for (const double share : Shares(values, 0.0, 1.0)) {
    const double at = 4.0 * (std::isfinite(share) ? share : 0.5);  // blue, cyan, green, yellow, red
    colors.push_back({Byte(at - 2.0), Byte(std::min(at, 4.0 - at)), Byte(2.0 - at)});
  }
  return colors;
}

}  // namespace ariadne::slam
