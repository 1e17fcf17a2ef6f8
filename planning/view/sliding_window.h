#pragma once

#include <optional>
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

/// The same among the windows of whose values at least a share is marked (1, else 0; one mark per value);
/// where two are in the middle of a plateau, the first. Nothing where no window has so many.
std::optional<Window> BestWindowWith(std::span<const int> values, int width, std::span<const int> marks,
                                     double least_share);

}  // namespace ariadne::planning
