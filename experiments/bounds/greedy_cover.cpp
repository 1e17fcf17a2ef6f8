#include "experiments/bounds/greedy_cover.h"

#include <queue>

namespace ariadne::experiments {
namespace {

/// Which elements what is chosen covers.
class Covered {
 public:
  explicit Covered(const ReducedCover& problem)
      : problem_(problem), is_covered_(problem.weights.size(), false) {}

  void Add(int set) {
    for (const int i : SetOf(set)) {
      if (!is_covered_[Index(i)]) weight_ += WeightOf(i);
      is_covered_[Index(i)] = true;
    }
  }
  /// What a set covers beyond what is covered already.
  double Gain(int set) const {
    double gain = 0.0;
    for (const int i : SetOf(set)) gain += is_covered_[Index(i)] ? 0.0 : WeightOf(i);
    return gain;
  }
  double weight() const { return weight_; }
  bool IsCover() const { return weight_ >= problem_.required; }

 private:
  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }
  const std::vector<int>& SetOf(int set) const { return problem_.sets[Index(set)]; }
  double WeightOf(int element) const { return problem_.weights[Index(element)]; }

  const ReducedCover& problem_;
  std::vector<bool> is_covered_;
  double weight_ = 0.0;
};

}  // namespace

std::vector<int> GreedyCover(const ReducedCover& problem) {
  Covered covered(problem);
  using Entry = std::pair<double, int>;  // gain, which can only shrink, and minus the set
  std::priority_queue<Entry> queue;
  for (int s = 0; s < static_cast<int>(problem.sets.size()); ++s) queue.emplace(covered.Gain(s), -s);
  std::vector<int> chosen;
  while (!covered.IsCover() && !queue.empty()) {
    const int set = -queue.top().second;
    queue.pop();
    const Entry now(covered.Gain(set), -set);
    if (!queue.empty() && now < queue.top()) {
      queue.push(now);
      continue;
    }
    covered.Add(set);
    chosen.push_back(set);
  }
  return chosen;
}

double CoveredWeight(const ReducedCover& problem, const std::vector<int>& chosen) {
  Covered covered(problem);
  for (const int set : chosen) covered.Add(set);
  return covered.weight();
}

}  // namespace ariadne::experiments
