#include "experiments/bounds/exact_tour.h"

#include <limits>

namespace ariadne::experiments {
namespace {

/// Shortest ways from the start through exactly the places of a subset, by the last of them.
class WaysThroughSubsets {
 public:
  WaysThroughSubsets(const Eigen::MatrixXd& distances, std::size_t start)
      : distances_(distances), start_(start) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(distances.rows()); ++i) {
      if (i != start) places_.push_back(i);
    }
    lengths_.assign(places_.size() << places_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < places_.size(); ++k) At(Bit(k), k) = Distance(start, places_[k]);
    for (std::size_t subset = 1; subset <= All(); ++subset) Extend(subset);
  }

  /// Back from the end of the shortest way: each place before is one through which the way is that short.
  std::vector<std::size_t> Order() const {
    std::vector<std::size_t> reversed;
    std::size_t subset = All();
    std::size_t after = places_.size();  // none
    while (subset != 0) {
      const std::size_t last = LastOf(subset, after);
      reversed.push_back(places_[last]);
      subset &= ~Bit(last);
      after = last;
    }
    reversed.push_back(start_);
    return {reversed.rbegin(), reversed.rend()};
  }

 private:
  static std::size_t Bit(std::size_t k) { return std::size_t{1} << k; }
  std::size_t All() const { return Bit(places_.size()) - 1; }
  double& At(std::size_t subset, std::size_t last) { return lengths_[subset * places_.size() + last]; }
  double At(std::size_t subset, std::size_t last) const { return lengths_[subset * places_.size() + last]; }
  double Distance(std::size_t a, std::size_t b) const {
    return distances_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
  }

  void Extend(std::size_t subset) {
    for (std::size_t last = 0; last < places_.size(); ++last) {
      if ((subset & Bit(last)) == 0) continue;
      const double length = At(subset, last);
      for (std::size_t next = 0; next < places_.size(); ++next) {
        if ((subset & Bit(next)) != 0) continue;
        double& further = At(subset | Bit(next), next);
        further = std::min(further, length + Distance(places_[last], places_[next]));
      }
    }
  }

  std::size_t LastOf(std::size_t subset, std::size_t after) const {
    std::size_t best = places_.size();
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t last = 0; last < places_.size(); ++last) {
      if ((subset & Bit(last)) == 0) continue;
      const double on = after < places_.size() ? Distance(places_[last], places_[after]) : 0.0;
      if (best < places_.size() && At(subset, last) + on >= shortest) continue;
      shortest = At(subset, last) + on;
      best = last;
    }
    return best;
  }

  const Eigen::MatrixXd& distances_;
  std::size_t start_;
  std::vector<std::size_t> places_;  // but for the start
  std::vector<double> lengths_;
};

}  // namespace

std::vector<std::size_t> ExactTour(const Eigen::MatrixXd& distances, std::size_t start) {
  return WaysThroughSubsets(distances, start).Order();
}

}  // namespace ariadne::experiments
