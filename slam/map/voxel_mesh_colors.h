#pragma once

#include <span>
#include <vector>

#include "slam/geometry/rgb.h"

namespace ariadne::slam {

/// A grey per value: from black to white between the 2nd and the 98th percentile, so that single glaring
/// points do not darken the rest. NaN is a middle grey.
std::vector<Rgb> GreyColors(std::span<const double> values);

/// From blue at the lowest value over green to red at the highest.
std::vector<Rgb> RainbowColors(std::span<const double> values);

}  // namespace ariadne::slam
