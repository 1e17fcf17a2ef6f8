#pragma once

#include "experiments/bounds/cover_reduction.h"

namespace ariadne::experiments {

/// The greedy cover of Sec. 4.1: always the set that adds most; of equal ones the first. In the order in
/// which they are taken. Indices of the reduced problem.
std::vector<int> GreedyCover(const ReducedCover& problem);

/// A cover of as many or fewer sets: superfluous ones are dropped, and two are exchanged for one, or one
/// for another that covers more, until none of it helps.
std::vector<int> ImprovedCover(const ReducedCover& problem, std::vector<int> chosen);

/// Weight of the elements of some sets together.
double CoveredWeight(const ReducedCover& problem, const std::vector<int>& chosen);

}  // namespace ariadne::experiments
