#pragma once

#include "experiments/bounds/cover_reduction.h"

namespace ariadne::experiments {

/// A cover of as many or fewer sets than the one to start from: whenever there is a cover, the set that is
/// missed least is left out, and single sets are exchanged for those that then add most until there is one
/// again. What covers less is accepted too, more and more rarely (simulated annealing). Ends with
/// `fewest` sets, the least that makes sense to look for, or after so many exchanges. The same each time.
std::vector<int> SwapSearch(const ReducedCover& problem, const std::vector<int>& start, int fewest,
                            int swaps);

}  // namespace ariadne::experiments
