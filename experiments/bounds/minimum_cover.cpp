#include "experiments/bounds/minimum_cover.h"

#include <algorithm>
#include <cmath>

#include "experiments/bounds/cover_program.h"
#include "experiments/bounds/cover_reduction.h"
#include "experiments/bounds/greedy_cover.h"

namespace ariadne::experiments {
namespace {

double WeightOf(const CoverProblem& problem, const std::vector<std::size_t>& chosen) {
  std::vector<bool> covered(problem.weights.size(), false);
  for (const std::size_t set : chosen) {
    for (const int i : problem.sets[set]) covered[static_cast<std::size_t>(i)] = true;
  }
  double weight = 0.0;
  for (std::size_t i = 0; i < covered.size(); ++i) weight += covered[i] ? problem.weights[i] : 0.0;
  return weight;
}

std::vector<std::size_t> AllOf(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

}  // namespace

CoverResult MinimumCover(const CoverProblem& problem, const CoverOptions& options) {
  CheckOptions(options, "cover.");
  const ReducedCover reduced = ReduceCover(problem, options.share);
  const std::vector<int> greedy = GreedyCover(reduced);
  const CoverProgramResult best = SolveCoverProgram(reduced, greedy, options);
  const bool valid = CoveredWeight(reduced, best.chosen) >= reduced.required;
  CoverResult result;
  for (const int set : valid ? best.chosen : greedy) {
    result.chosen.push_back(reduced.original[static_cast<std::size_t>(set)]);
  }
  std::sort(result.chosen.begin(), result.chosen.end());
  const int size = static_cast<int>(result.chosen.size());
  result.relaxation = best.relaxation;
  result.lower_bound = std::min(size, best.bound);
  result.proven = result.lower_bound == size;
  result.greedy_size = static_cast<int>(greedy.size());
  result.covered = WeightOf(problem, result.chosen);
  result.coverable = WeightOf(problem, AllOf(problem.sets.size()));
  return result;
}

}  // namespace ariadne::experiments
