#pragma once

#include <cstddef>
#include <vector>

#include "slam/base/options.h"

namespace ariadne::experiments {

/// What is to be covered, and what by: for views of a building, pieces of wall and who sees them.
struct CoverProblem {
  std::vector<double> weights;         // of the elements, such as lengths of wall [m]
  std::vector<std::vector<int>> sets;  // of indices of elements, in any order
};

/// How much must be covered, and how long to search.
struct CoverOptions {
  double share = 0.95;
  int swaps = 20000;
  int max_nodes = 2000;
  int max_iterations = 30000;
  double max_seconds = 300.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("share", self.share, Unit(""), Range{1e-6, 1.0},
          "of the weight that all sets cover together; 1: all of it");
    visit("swaps", self.swaps, Unit(""), Range{0, 1e9},
          "that the search for a cover tries before the program");
    visit("max_nodes", self.max_nodes, Unit(""), Range{0, 1e9},
          "of branch and bound; 0: the relaxation's bound alone");
    visit("max_iterations", self.max_iterations, Unit(""), Range{0, 1e9},
          "of the simplex algorithm in branch and bound; with 3000 views of 5000 pieces of wall, 1 to 2 ms "
          "each");
    visit("max_seconds", self.max_seconds, Unit("s"), Range{1.0, 1e6},
          "for safety: results that end by it differ from run to run");
  }
};

/// The smallest cover that was found, and how small one can be at best.
struct CoverResult {
  std::vector<std::size_t> chosen;  // of the sets, ascending
  int lower_bound = 0;              // no cover has fewer sets
  bool proven = false;              // that chosen is as few as lower_bound
  double relaxation = 0.0;          // the bound of the linear relaxation, before it is rounded up
  int greedy_size = 0;              // of the greedy cover, before it was improved
  double covered = 0.0;             // weight of what is chosen
  double coverable = 0.0;           // weight of all sets together
};

/// The fewest sets that weigh `share` of what is coverable (to a relative 1e-6): the offline version of the
/// art gallery of Sec. 4.1, there solved greedily, as an integer program (CBC). Where the search ends
/// before the proof, the best cover so far and the bound remain, both of them valid. Error where an index,
/// a weight or an option is none, and where no set covers anything.
CoverResult MinimumCover(const CoverProblem& problem, const CoverOptions& options);

}  // namespace ariadne::experiments
