#include "experiments/bounds/swap_search.h"

#include <cmath>

#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

constexpr double kHottest = 0.05;  // of the weight of one set; 0.01 to 0.3 find covers of the same size

/// Some sets, and what every set would change: weight that it alone covers, or would add.
class SwapState {
 public:
  SwapState(const ReducedCover& problem, const std::vector<int>& start)
      : problem_(problem), counts_(problem.weights.size(), 0), inside_(problem.sets.size(), false) {
    for (std::size_t s = 0; s < problem.sets.size(); ++s) {
      double weight = 0.0;
      for (const int i : problem.sets[s]) weight += problem.weights[Index(i)];
      scores_.push_back(weight);
    }
    for (const int set : start) Add(Index(set));
  }

  bool IsCover() const { return covered_ >= problem_.required; }

  void Add(std::size_t set) {
    covered_ += scores_[set];
    inside_[set] = true;
    for (const int i : problem_.sets[set]) {
      const int count = ++counts_[Index(i)];
      if (count == 1) AddToOthers(i, set, -problem_.weights[Index(i)]);
      if (count == 2) AddToOtherInside(i, set, -problem_.weights[Index(i)]);
    }
    RecomputeScore(set, 1);
  }

  void Remove(std::size_t set) {
    covered_ -= scores_[set];
    inside_[set] = false;
    for (const int i : problem_.sets[set]) {
      const int count = --counts_[Index(i)];
      if (count == 0) AddToOthers(i, set, problem_.weights[Index(i)]);
      if (count == 1) AddToOtherInside(i, set, problem_.weights[Index(i)]);
    }
    RecomputeScore(set, 0);
  }

  std::size_t LeastMissed() const {
    std::size_t least = scores_.size();
    for (std::size_t s = 0; s < scores_.size(); ++s) {
      if (inside_[s] && (least == scores_.size() || scores_[s] < scores_[least])) least = s;
    }
    return least;
  }

  /// The set that adds most, but for one.
  std::size_t BestToAdd(std::size_t except) const {
    std::size_t best = scores_.size();
    for (std::size_t s = 0; s < scores_.size(); ++s) {
      if (inside_[s] || s == except) continue;
      if (best == scores_.size() || scores_[s] > scores_[best]) best = s;
    }
    return best;
  }

  double covered() const { return covered_; }

  std::vector<int> Chosen() const {
    std::vector<int> chosen;
    for (std::size_t s = 0; s < inside_.size(); ++s) {
      if (inside_[s]) chosen.push_back(static_cast<int>(s));
    }
    return chosen;
  }

 private:
  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }

  void AddToOthers(int element, std::size_t set, double weight) {
    for (const int other : problem_.sets_with[Index(element)]) {
      if (Index(other) != set) scores_[Index(other)] += weight;
    }
  }

  /// The only other one inside that has the element.
  void AddToOtherInside(int element, std::size_t set, double weight) {
    for (const int other : problem_.sets_with[Index(element)]) {
      if (Index(other) == set || !inside_[Index(other)]) continue;
      scores_[Index(other)] += weight;
      return;
    }
  }

  void RecomputeScore(std::size_t set, int count) {
    double score = 0.0;
    for (const int i : problem_.sets[set]) {
      if (counts_[Index(i)] == count) score += problem_.weights[Index(i)];
    }
    scores_[set] = score;
  }

  const ReducedCover& problem_;
  std::vector<int> counts_;
  std::vector<bool> inside_;
  std::vector<double> scores_;
  double covered_ = 0.0;
};

}  // namespace

std::vector<int> SwapSearch(const ReducedCover& problem, const std::vector<int>& start, int fewest,
                            int swaps) {
  RandomStream stream = NamedStream(1, "cover/swaps");
  SwapState state(problem, start);
  std::vector<int> best = start;
  const double hottest = kHottest * problem.required / static_cast<double>(start.size());
  for (int step = 0; step < swaps; ++step) {
    while (state.IsCover()) {
      best = state.Chosen();
      if (best.size() <= static_cast<std::size_t>(fewest)) return best;
      state.Remove(state.LeastMissed());
    }
    const std::vector<int> chosen = state.Chosen();
    if (chosen.empty() || chosen.size() + 1 >= problem.sets.size()) break;
    const auto out = static_cast<std::size_t>(
        chosen[static_cast<std::size_t>(DrawUniform(stream, 0.0, static_cast<double>(chosen.size())))]);
    const double before = state.covered();
    state.Remove(out);
    const std::size_t in = state.BestToAdd(out);
    state.Add(in);
    const double temperature = hottest * (1.0 - static_cast<double>(step) / swaps);
    const double loss = before - state.covered();
    if (loss <= 0.0 || DrawUniform(stream, 0.0, 1.0) < std::exp(-loss / temperature)) continue;
    state.Remove(in);
    state.Add(out);
  }
  return best;
}

}  // namespace ariadne::experiments
