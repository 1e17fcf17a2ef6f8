#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ariadne::experiments {

/// The value below which the given share (0 to 1) of the values lies: the nearest rank, so always one of
/// them. 0 without values.
template <typename T>
T Percentile(std::vector<T> values, double share) {
  if (values.empty()) return T{};
  const double rank = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + std::lround(rank);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace ariadne::experiments
