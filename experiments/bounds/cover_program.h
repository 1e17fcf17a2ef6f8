#pragma once

#include "experiments/bounds/cover_reduction.h"

namespace ariadne::experiments {

/// What branch and bound says of a problem.
struct CoverProgramResult {
  std::vector<int> chosen;  // a cover of fewer sets than the one it began with, or that one
  int bound = 0;            // no cover has fewer sets
  double relaxation = 0.0;  // the bound of the linear relaxation
};

/// Minimizes sum x_s over x_s in {0, 1} and 0 <= y_i <= 1, subject to y_i <= sum of x_s over the sets with
/// element i, and sum w_i y_i >= required; y_i = 1 for mandatory elements. Begins with a cover, which
/// it first improves by SwapSearch.
CoverProgramResult SolveCoverProgram(const ReducedCover& problem, const std::vector<int>& start,
                                     const CoverOptions& options);

}  // namespace ariadne::experiments
