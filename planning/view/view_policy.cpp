#include "planning/view/view_policy.h"

#include <algorithm>
#include <cmath>

#include "slam/base/random.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

constexpr double kPotentialReach = 5.0;  // lambda = 0.2 / m (Gonzalez-Banos, Latombe 2002) [m]
constexpr std::size_t kPairs = 20;       // views of which pairs are looked at

template <typename Value>
std::size_t BestOf(std::span<const std::size_t> among, const Value& value) {
  std::size_t best = among.front();
  double highest = value(best);
  for (const std::size_t i : among.subspan(1)) {
    const double one = value(i);
    if (one > highest) best = i, highest = one;
  }
  return best;
}

/// How many ascending numbers of `a` are not in `b`.
std::size_t CountNew(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::size_t count = 0;
  auto at = b.begin();
  for (const std::uint32_t one : a) {
    while (at != b.end() && *at < one) ++at;
    count += at == b.end() || *at != one ? 1 : 0;
  }
  return count;
}

double LogPenalty(const View& view, const NextViewOptions& options) {
  return -options.distance_weight * view.distance - options.angle_weight * slam::DegFromRad(view.turn);
}

std::size_t ChooseOfTwoSteps(const ViewChoice& choice, const NextViewOptions& options) {
  const auto alone = [&](std::size_t i) {
    return static_cast<double>(choice.elements[i].size()) * std::exp(LogPenalty(choice.views[i], options));
  };
  std::vector<std::size_t> best = choice.worth;
  std::ranges::stable_sort(best, [&](std::size_t a, std::size_t b) { return alone(a) > alone(b); });
  best.resize(std::min(best.size(), kPairs));
  const auto with_second = [&](std::size_t first) {
    const std::vector<double> ways = choice.ways(first, best);
    double further = 0.0;
    for (std::size_t k = 0; k < best.size(); ++k) {
      const auto fresh = static_cast<double>(CountNew(choice.elements[best[k]], choice.elements[first]));
      const double way = choice.views[first].distance + ways[k];
      further = std::max(further, fresh * std::exp(-options.distance_weight * way));
    }
    return alone(first) + further;
  };
  return BestOf(best, with_second);
}

/// The order of least way that begins at the robot, by insertion and 2-opt; `way[i][j]`, the robot last.
std::vector<std::size_t> ShortOrder(const std::vector<std::vector<double>>& way) {
  const std::size_t robot = way.size() - 1;
  std::vector<std::size_t> order;
  std::vector<bool> taken(robot, false);
  for (std::size_t at = robot; order.size() < robot; at = order.back()) {
    std::size_t nearest = robot;
    for (std::size_t i = 0; i < robot; ++i) {
      if (!taken[i] && (nearest == robot || way[at][i] < way[at][nearest])) nearest = i;
    }
    taken[nearest] = true;
    order.push_back(nearest);
  }
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (std::size_t i = 0; i < robot; ++i) {
      for (std::size_t j = i + 1; j < robot; ++j) {
        const std::size_t before = i == 0 ? robot : order[i - 1];
        double change = way[before][order[j]] - way[before][order[i]];
        if (j + 1 < robot) change += way[order[i]][order[j + 1]] - way[order[j]][order[j + 1]];
        if (change >= -1e-9) continue;
        std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                     order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        shorter = true;
      }
    }
  }
  return order;
}

std::size_t ChooseOfTour(const ViewChoice& choice) {
  const std::vector<std::size_t> cover = CoveringViews(choice);
  std::vector<std::vector<double>> way;
  for (const std::size_t i : cover) {
    way.push_back(choice.ways(i, cover));
    way.back().push_back(choice.views[i].distance);
  }
  way.emplace_back();
  for (const std::size_t i : cover) way.back().push_back(choice.views[i].distance);
  return cover[ShortOrder(way).front()];
}

}  // namespace

bool LooksAhead(ViewPolicy policy) {
  return policy == ViewPolicy::kTwoSteps || policy == ViewPolicy::kTour;
}

std::vector<std::size_t> CoveringViews(const ViewChoice& choice) {
  std::vector<bool> covered(choice.element_count, false);
  const auto fresh = [&](std::size_t i) {
    return std::ranges::count_if(choice.elements[i], [&](std::uint32_t e) { return !covered[e]; });
  };
  std::vector<std::size_t> cover;
  for (;;) {
    const std::size_t best =
        BestOf(choice.worth, [&](std::size_t i) { return static_cast<double>(fresh(i)); });
    if (fresh(best) == 0) break;
    cover.push_back(best);
    for (const std::uint32_t e : choice.elements[best]) covered[e] = true;
  }
  return cover;
}

std::size_t ChooseView(const ViewChoice& choice, const ViewPlannerOptions& options, std::uint64_t seed) {
  const auto view = [&](std::size_t i) -> const View& { return choice.views[i]; };
  switch (options.policy) {
    case ViewPolicy::kExponential:
      return BestOf(choice.worth, [&](std::size_t i) {
        return std::log(view(i).gain) + LogPenalty(view(i), options.view);
      });
    case ViewPolicy::kGain:
      return BestOf(choice.worth, [&](std::size_t i) { return view(i).gain; });
    case ViewPolicy::kNearestFrontier:
      return BestOf(choice.worth, [&](std::size_t i) { return -view(i).distance; });
    case ViewPolicy::kPotentialArea:
      return BestOf(choice.worth, [&](std::size_t i) {
        return std::log(view(i).area) - view(i).distance / kPotentialReach;
      });
    case ViewPolicy::kTwoSteps:
      return ChooseOfTwoSteps(choice, options.view);
    case ViewPolicy::kTour:
      return ChooseOfTour(choice);
    case ViewPolicy::kRandom:
      break;
  }
  RandomStream stream = NamedStream(seed, "view/random");
  return choice.worth[stream() % choice.worth.size()];
}

}  // namespace ariadne::planning
