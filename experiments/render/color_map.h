#pragma once

#include <cstddef>
#include <vector>

#include "experiments/render/color.h"

namespace ariadne::experiments {

/// Colours for a value from low to high. Equal steps of the value look equally large, lightness only rises
/// or only falls (so that prints in grey remain readable), and no colour vanishes on white.
enum class ColorMap {
  kSea,    // violet, blue, green, yellow: height, time, any quantity
  kShore,  // sand, teal, blue: heights, where a pale floor lets shading and walls be seen
  kHeat,   // pale, orange, red, dark: errors, where the large values are to be seen
  kGray,   // dark to light: reflectance
};

/// The colour at a share of the map, 0 (low) to 1 (high); values beyond take the colour of the end.
Rgb ColorAt(ColorMap map, double share);

inline constexpr std::size_t kCategoricalColors = 20;

/// A colour for the index-th of several things (scans, methods). The first 20 differ from each other, and
/// most from their predecessor, also for readers with red-green blindness; then they repeat.
Rgb CategoricalColor(std::size_t index);

/// The values that take the two end colours of a map.
struct ValueRange {
  double low = 0.0;
  double high = 1.0;

  /// Where a value lies between low (0) and high (1).
  double Share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// The range of the values without a share of outliers at each end.
ValueRange RobustRange(const std::vector<double>& values, double outlier_share = 0.01);

}  // namespace ariadne::experiments
