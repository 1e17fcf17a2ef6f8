#pragma once

#include <span>

namespace ariadne::planning {

/// A window over values around a circle.
struct Window {
  int sum = 0;
  double center = 0.0;  // in steps from value 0, in (-n/2, n/2]; halfway between two for even widths
};

/// The window of `width` neighbours with the largest sum. Where several in a row have it, the centre of
/// that plateau, so that small errors of the pose do not matter; of several plateaus the longest, then the
/// one nearest to value 0, then the one on its left (counterclockwise). Where all windows have the same
/// sum, the one about value 0. Values must not be empty; a width beyond their number is that number.
Window BestWindow(std::span<const int> values, int width);

}  // namespace ariadne::planning
