#pragma once

#include <cstddef>
#include <span>

namespace ariadne::planning {

/// The one of `among`, which must not be empty, with the highest value(i); of equal ones the first.
template <typename Value>
std::size_t BestOf(std::span<const std::size_t> among, const Value& value) {
  std::size_t best = among.front();
  double highest = value(best);
  for (const std::size_t i : among.subspan(1)) {
    const double one = value(i);
    if (one > highest) best = i, highest = one;
  }
  return best;
}

}  // namespace ariadne::planning
