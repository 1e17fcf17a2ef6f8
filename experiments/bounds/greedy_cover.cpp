#include "experiments/bounds/greedy_cover.h"

#include <algorithm>
#include <optional>
#include <queue>

namespace ariadne::experiments {
namespace {

/// How often each element is covered by what is chosen.
class CoverCounts {
 public:
  explicit CoverCounts(const ReducedCover& problem)
      : problem_(problem), counts_(problem.weights.size(), 0) {}

  void Add(int set) {
    for (const int i : SetOf(set)) {
      if (counts_[Index(i)]++ == 0) covered_ += WeightOf(i);
    }
  }
  void Remove(int set) {
    for (const int i : SetOf(set)) {
      if (--counts_[Index(i)] == 0) covered_ -= WeightOf(i);
    }
  }
  /// What a set covers beyond what is covered `times` already.
  double Alone(int set, int times) const {
    double gain = 0.0;
    for (const int i : SetOf(set)) gain += counts_[Index(i)] <= times ? WeightOf(i) : 0.0;
    return gain;
  }
  double covered() const { return covered_; }
  bool IsCover() const { return covered_ >= problem_.required; }
  /// What each set of the problem would add.
  std::vector<double> Gains() const {
    std::vector<double> gains(problem_.sets.size(), 0.0);
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] > 0) continue;
      for (const int set : problem_.sets_with[i]) gains[Index(set)] += problem_.weights[i];
    }
    return gains;
  }

 private:
  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }
  const std::vector<int>& SetOf(int set) const { return problem_.sets[Index(set)]; }
  double WeightOf(int element) const { return problem_.weights[Index(element)]; }

  const ReducedCover& problem_;
  std::vector<int> counts_;
  double covered_ = 0.0;
};

void DropSuperfluous(CoverCounts& counts, std::vector<int>& chosen) {
  for (;;) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < chosen.size(); ++k) {
      if (counts.Alone(chosen[k], 1) < counts.Alone(chosen[least], 1)) least = k;
    }
    if (chosen.empty()) return;
    counts.Remove(chosen[least]);
    if (!counts.IsCover()) return counts.Add(chosen[least]);
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

int SetOfLargestGain(const CoverCounts& counts) {
  const std::vector<double> gains = counts.Gains();
  return static_cast<int>(std::max_element(gains.begin(), gains.end()) - gains.begin());
}

/// One for one, where it covers more by more than rounding.
bool ExchangeOne(CoverCounts& counts, std::vector<int>& chosen) {
  for (int& set : chosen) {
    const double before = counts.covered();
    counts.Remove(set);
    const int other = SetOfLargestGain(counts);
    counts.Add(other);
    const bool better = counts.covered() > before * (1.0 + 1e-9);
    if (!better) counts.Remove(other), counts.Add(set);
    if (better) set = other;
    if (better) return true;
  }
  return false;
}

bool ExchangeTwoForOne(CoverCounts& counts, std::vector<int>& chosen) {
  for (std::size_t a = 0; a < chosen.size(); ++a) {
    counts.Remove(chosen[a]);
    for (std::size_t b = a + 1; b < chosen.size(); ++b) {
      counts.Remove(chosen[b]);
      const int other = SetOfLargestGain(counts);
      counts.Add(other);
      if (counts.IsCover()) {
        chosen[a] = other;
        chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(b));
        return true;
      }
      counts.Remove(other);
      counts.Add(chosen[b]);
    }
    counts.Add(chosen[a]);
  }
  return false;
}

}  // namespace

std::vector<int> GreedyCover(const ReducedCover& problem) {
  CoverCounts counts(problem);
  using Entry = std::pair<double, int>;  // gain, which can only shrink, and minus the set
  std::priority_queue<Entry> queue;
  for (int s = 0; s < static_cast<int>(problem.sets.size()); ++s) queue.emplace(counts.Alone(s, 0), -s);
  std::vector<int> chosen;
  while (!counts.IsCover() && !queue.empty()) {
    const int set = -queue.top().second;
    queue.pop();
    const Entry now(counts.Alone(set, 0), -set);
    if (!queue.empty() && now < queue.top()) {
      queue.push(now);
      continue;
    }
    counts.Add(set);
    chosen.push_back(set);
  }
  return chosen;
}

std::vector<int> ImprovedCover(const ReducedCover& problem, std::vector<int> chosen) {
  CoverCounts counts(problem);
  for (const int set : chosen) counts.Add(set);
  do {
    DropSuperfluous(counts, chosen);
  } while (ExchangeTwoForOne(counts, chosen) || ExchangeOne(counts, chosen));
  return chosen;
}

double CoveredWeight(const ReducedCover& problem, const std::vector<int>& chosen) {
  CoverCounts counts(problem);
  for (const int set : chosen) counts.Add(set);
  return counts.covered();
}

}  // namespace ariadne::experiments
