#include "drivers/differential_frames.h"

#include <algorithm>
#include <cmath>

namespace ariadne::drivers {
namespace {

/// The range of a beam, cut at `max_range`, where what did not come back is too. Cut, not left out: a wall
/// just at that range changes by its noise alone.
double RangeOf(const slam::LaserSweep& sweep, std::size_t beam, double max_range) {
  const auto range = static_cast<double>(sweep.ranges[beam]);
  return range < max_range ? range : max_range;  // false for NaN
}

}  // namespace

std::vector<MovedBeams> DifferenceOf(const slam::LaserSweep& before, const slam::LaserSweep& after,
                                     const DifferentialFrameOptions& options, std::size_t scanner) {
  const std::size_t beams = before.ranges.size();
  if (after.ranges.size() != beams) {
    Fail("frames of one scanner cannot have {} and {} beams", beams, after.ranges.size());
  }
  std::vector<MovedBeams> moved;
  for (std::size_t first = 0; first < beams; ++first) {
    double largest = 0.0;
    std::size_t end = first;
    for (; end < beams; ++end) {
      const double change =
          std::abs(RangeOf(after, end, options.max_range) - RangeOf(before, end, options.max_range));
      if (change < options.min_difference) break;
      largest = std::max(largest, change);
    }
    if (end - first >= static_cast<std::size_t>(options.min_adjacent_beams)) {
      moved.push_back({scanner, first, end - 1, before.stamp, after.stamp, largest});
    }
    first = end;  // this beam did not change
  }
  return moved;
}

std::vector<MovedBeams> DetectMotion(std::span<const std::vector<SafetySweep>> frames,
                                     const DifferentialFrameOptions& options) {
  std::vector<MovedBeams> moved;
  for (std::size_t f = 1; f < frames.size(); ++f) {
    if (frames[f].size() != frames[f - 1].size()) {
      Fail("frames of the same scanners cannot have {} and {} sweeps", frames[f - 1].size(),
           frames[f].size());
    }
    for (std::size_t s = 0; s < frames[f].size(); ++s) {
      const auto runs = DifferenceOf(frames[f - 1][s].sweep, frames[f][s].sweep, options, s);
      moved.insert(moved.end(), runs.begin(), runs.end());
    }
  }
  return moved;
}

}  // namespace ariadne::drivers
