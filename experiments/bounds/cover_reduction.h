#pragma once

#include "experiments/bounds/minimum_cover.h"

namespace ariadne::experiments {

/// A problem with the same covers of fewest sets, or some of them, on fewer elements and sets.
struct ReducedCover {
  std::vector<double> weights;              // positive
  double required = 0.0;                    // weight that makes a cover
  std::vector<std::vector<int>> sets;       // of elements, ascending
  std::vector<std::vector<int>> sets_with;  // for each element, ascending
  std::vector<std::size_t> original;        // of each set, its index in the problem; ascending

  /// Without such an element nothing is a cover.
  bool Mandatory(std::size_t element) const { return total - weights[element] < required; }
  double total = 0.0;  // of the weights
};

/// Leaves out elements that no set has or that weigh nothing, makes one of elements that are in the same
/// sets, and leaves out sets whose elements another has as well, and elements that come along with a
/// mandatory one; until nothing changes. Error for an invalid problem.
ReducedCover ReduceCover(const CoverProblem& problem, double share);

}  // namespace ariadne::experiments
