#include "experiments/bounds/cover_reduction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace ariadne::experiments {
namespace {

using Lists = std::vector<std::vector<int>>;

constexpr double kRounding = 1e-6;  // of the required weight: sums differ with their order

void RequireValid(const CoverProblem& problem) {
  for (std::size_t i = 0; i < problem.weights.size(); ++i) {
    const double weight = problem.weights[i];
    if (!(weight >= 0.0) || !std::isfinite(weight)) Fail("element {} to be covered weighs {}", i, weight);
  }
  for (std::size_t s = 0; s < problem.sets.size(); ++s) {
    for (const int element : problem.sets[s]) {
      if (element >= 0 && static_cast<std::size_t>(element) < problem.weights.size()) continue;
      Fail("set {} has element {}, but there are {}", s, element, problem.weights.size());
    }
  }
}

Lists Transposed(const Lists& lists, std::size_t count) {
  Lists transposed(count);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (const int j : lists[i]) transposed[static_cast<std::size_t>(j)].push_back(static_cast<int>(i));
  }
  return transposed;
}

/// The problem with every element once in a set, and without elements that do not count.
ReducedCover Normalized(const CoverProblem& problem, double share) {
  ReducedCover cover;
  cover.weights = problem.weights;
  cover.original.resize(problem.sets.size());
  std::iota(cover.original.begin(), cover.original.end(), std::size_t{0});
  for (std::vector<int> set : problem.sets) {
    std::erase_if(set, [&](int i) { return problem.weights[static_cast<std::size_t>(i)] == 0.0; });
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    cover.sets.push_back(std::move(set));
  }
  cover.sets_with = Transposed(cover.sets, cover.weights.size());
  for (std::size_t i = 0; i < cover.weights.size(); ++i) {
    if (cover.sets_with[i].empty()) continue;
    if (share == 1.0) cover.weights[i] = 1.0;  // all are needed, and counting is exact
    cover.total += cover.weights[i];
  }
  cover.required = share == 1.0 ? cover.total - 0.5 : share * cover.total * (1.0 - kRounding);
  return cover;
}

/// The same with the elements of the keys alone; each stands for the elements of its value.
void KeepElements(ReducedCover& cover, const std::map<std::vector<int>, double>& weight_of_sets) {
  cover.weights.clear();
  cover.sets_with.clear();
  for (const auto& [sets_with, weight] : weight_of_sets) {
    cover.sets_with.push_back(sets_with);
    cover.weights.push_back(weight);
  }
  cover.sets = Transposed(cover.sets_with, cover.sets.size());
  cover.total = std::accumulate(cover.weights.begin(), cover.weights.end(), 0.0);
}

void MergeElements(ReducedCover& cover) {
  std::map<std::vector<int>, double> weight_of_sets;
  for (std::size_t i = 0; i < cover.weights.size(); ++i) {
    if (!cover.sets_with[i].empty()) weight_of_sets[cover.sets_with[i]] += cover.weights[i];
  }
  KeepElements(cover, weight_of_sets);
}

bool Includes(const std::vector<int>& large, const std::vector<int>& small) {
  return std::includes(large.begin(), large.end(), small.begin(), small.end());
}

/// The list of lists_with[i] that is shortest over the entries i of a list.
const std::vector<int>& ShortestOf(const std::vector<int>& list, const Lists& lists_with) {
  const int i = *std::min_element(list.begin(), list.end(), [&](int a, int b) {
    return lists_with[static_cast<std::size_t>(a)].size() < lists_with[static_cast<std::size_t>(b)].size();
  });
  return lists_with[static_cast<std::size_t>(i)];
}

bool IsDominated(const ReducedCover& cover, std::size_t s) {
  const std::vector<int>& set = cover.sets[s];
  if (set.empty()) return true;
  const std::vector<int>& others = ShortestOf(set, cover.sets_with);
  return std::any_of(others.begin(), others.end(), [&](int other) {
    const auto o = static_cast<std::size_t>(other);
    if (o == s || cover.sets[o].size() < set.size()) return false;
    if (cover.sets[o].size() == set.size() && o > s) return false;  // of equal ones the first stays
    return Includes(cover.sets[o], set);
  });
}

bool DropDominatedSets(ReducedCover& cover) {
  Lists sets;
  std::vector<std::size_t> original;
  for (std::size_t s = 0; s < cover.sets.size(); ++s) {
    if (IsDominated(cover, s)) continue;
    sets.push_back(cover.sets[s]);
    original.push_back(cover.original[s]);
  }
  const bool dropped = sets.size() < cover.sets.size();
  cover.sets = std::move(sets);
  cover.original = std::move(original);
  cover.sets_with = Transposed(cover.sets, cover.weights.size());
  return dropped;
}

/// Whoever covers a mandatory element covers those that are in all of its sets.
void DropImpliedElements(ReducedCover& cover) {
  std::vector<bool> implied(cover.weights.size(), false);
  for (std::size_t m = 0; m < cover.weights.size(); ++m) {
    if (implied[m] || !cover.Mandatory(m)) continue;
    for (const int i : ShortestOf(cover.sets_with[m], cover.sets)) {
      const auto e = static_cast<std::size_t>(i);
      if (e != m && !implied[e] && Includes(cover.sets_with[e], cover.sets_with[m])) implied[e] = true;
    }
  }
  std::map<std::vector<int>, double> weight_of_sets;
  for (std::size_t i = 0; i < cover.weights.size(); ++i) {
    if (implied[i]) {
      cover.required -= cover.weights[i];
    } else {
      weight_of_sets[cover.sets_with[i]] = cover.weights[i];
    }
  }
  KeepElements(cover, weight_of_sets);
}

}  // namespace

ReducedCover ReduceCover(const CoverProblem& problem, double share) {
  RequireValid(problem);
  ReducedCover cover = Normalized(problem, share);
  if (cover.total == 0.0) Fail("none of the {} sets covers anything", problem.sets.size());
  do {
    MergeElements(cover);
    DropImpliedElements(cover);
  } while (DropDominatedSets(cover));
  return cover;
}

}  // namespace ariadne::experiments
