#pragma once

#include "experiments/bounds/cover_reduction.h"

namespace ariadne::experiments {

/// The greedy cover of Sec. 4.1: always the set that adds most; of equal ones the first. In the order in
/// which they are taken. Indices of the reduced problem.
std::vector<int> GreedyCover(const ReducedCover& problem);

/// Weight of the elements of some sets together.
double CoveredWeight(const ReducedCover& problem, const std::vector<int>& chosen);

}  // namespace ariadne::experiments
