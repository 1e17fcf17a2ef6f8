#include "planning/view/view_policy.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "planning/view/best_of.h"
#include "slam/base/random.h"

namespace ariadne::planning {
namespace {

constexpr double kPotentialReach = 5.0;  // lambda = 0.2 / m (Gonzalez-Banos, Latombe 2002) [m]
constexpr std::size_t kPairs = 20;       // views of which pairs are looked at
constexpr double kRasterShare = 0.99;    // of a straight line, that no way falls below

/// The gain by pieces of `second` that `first` does not show.
double FurtherGain(const std::vector<EdgePiece>& first, const std::vector<EdgePiece>& second) {
  double gain = 0.0;
  auto at = first.begin();
  for (const EdgePiece& piece : second) {
    while (at != first.end() && at->number < piece.number) ++at;
    gain += at == first.end() || at->number != piece.number ? piece.gain : 0.0;
  }
  return gain;
}

std::size_t ChooseOfTwoSteps(const ViewChoice& choice, const NextViewOptions& options) {
  const auto alone = [&](std::size_t i) { return std::exp(LogValue(choice.views[i], options)); };
  std::vector<std::size_t> best = choice.worth;
  std::ranges::stable_sort(best, [&](std::size_t a, std::size_t b) { return alone(a) > alone(b); });
  best.resize(std::min(best.size(), kPairs));
  // No way is shorter than the straight line, but for the rounding of ways on a raster.
  const auto at_most = [&](std::size_t first) {
    double further = 0.0;
    for (const std::size_t second : best) {
      const double straight = (choice.views[first].p_map - choice.views[second].p_map).norm();
      const double way = choice.views[first].distance + kRasterShare * straight;
      const double gain = FurtherGain(choice.pieces[first], choice.pieces[second]);
      further = std::max(further, gain * std::exp(-options.distance_weight * way));
    }
    return alone(first) + further;
  };
  double highest = 0.0;
  const auto with_second = [&](std::size_t first) {
    if (at_most(first) <= highest) return 0.0;  // it cannot win: spare the search for its ways
    const std::vector<double> ways = choice.ways(first, best);
    double further = 0.0;
    for (std::size_t k = 0; k < best.size(); ++k) {
      const double way = choice.views[first].distance + ways[k];
      const double gain = FurtherGain(choice.pieces[first], choice.pieces[best[k]]);
      further = std::max(further, gain * std::exp(-options.distance_weight * way));
    }
    highest = std::max(highest, alone(first) + further);
    return alone(first) + further;
  };
  return BestOf(best, with_second);
}

/// Those of the views worth a scan that are not left for later.
std::vector<std::size_t> NotForLater(const ViewChoice& choice, const ViewPlannerOptions& options) {
  const auto gain = [&](std::size_t i) { return GainOf(choice.views[i], options.view); };
  double largest = 0.0;
  for (const std::size_t i : choice.worth) largest = std::max(largest, gain(i));
  std::vector<std::size_t> now;
  std::ranges::copy_if(choice.worth, std::back_inserter(now),
                       [&](std::size_t i) { return gain(i) >= options.least_share * largest; });
  return now;
}

}  // namespace

bool LooksAhead(ViewPolicy policy) { return policy == ViewPolicy::kTwoSteps; }

std::size_t ChooseView(const ViewChoice& choice, const ViewPlannerOptions& options, std::uint64_t seed) {
  const auto view = [&](std::size_t i) -> const View& { return choice.views[i]; };
  switch (options.policy) {
    case ViewPolicy::kExponential:
      return BestOf(NotForLater(choice, options),
                    [&](std::size_t i) { return LogValue(view(i), options.view); });
    case ViewPolicy::kGain:
      return BestOf(choice.worth, [&](std::size_t i) { return GainOf(view(i), options.view); });
    case ViewPolicy::kNearestFrontier:
      return BestOf(choice.worth, [&](std::size_t i) { return -view(i).distance; });
    case ViewPolicy::kPotentialArea:
      return BestOf(choice.worth, [&](std::size_t i) {
        return std::log(view(i).area) - view(i).distance / kPotentialReach;
      });
    case ViewPolicy::kTwoSteps:
      return ChooseOfTwoSteps(choice, options.view);
    case ViewPolicy::kRandom:
      break;
  }
  RandomStream stream = NamedStream(seed, "view/random");
  return choice.worth[stream() % choice.worth.size()];
}

}  // namespace ariadne::planning
