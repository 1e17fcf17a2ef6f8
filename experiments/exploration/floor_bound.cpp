#include "experiments/exploration/floor_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

/// What is seen around a place, and where it lies.
struct Surrounding {
  std::vector<std::uint32_t> places;
  std::vector<double> bearings;  // in the map [rad]
};

Surrounding LookAround(const Floor& floor, const Eigen::Vector2d& p, const FloorCover& cover,
                       FloorScannerOptions scanner) {
  scanner.field_of_view = 360.0;
  Surrounding around{SeenPlaces(ViewFloor(floor, {0.0, p}, scanner), cover, scanner), {}};
  for (const std::uint32_t k : around.places) {
    const Eigen::Vector2d d = cover.places_map[k] - p;
    around.bearings.push_back(std::atan2(d.y(), d.x()));
  }
  return around;
}

/// What of the surrounding is within the field of view, and not yet seen; numbered anew.
std::vector<int> Within(const Surrounding& around, double heading, double half_view,
                        const std::vector<int>& number) {
  std::vector<int> within;
  for (std::size_t i = 0; i < around.places.size(); ++i) {
    if (number[around.places[i]] < 0) continue;
    if (std::abs(slam::WrapAngle(around.bearings[i] - heading)) > half_view) continue;
    within.push_back(number[around.places[i]]);
  }
  return within;
}

/// Numbers for what the first view does not show; -1 for what it does.
std::vector<int> NumberRest(const std::vector<std::uint32_t>& seen, std::size_t count) {
  std::vector<int> number(count, 0);
  for (const std::uint32_t k : seen) number[k] = -1;
  int next = 0;
  for (int& n : number) n = n < 0 ? n : next++;
  return number;
}

/// Which share of what the sets cover makes up, with the first view, a share of everything.
double RestShare(const CoverProblem& problem, double first, double all, double share) {
  std::vector<bool> covered(problem.weights.size(), false);
  for (const auto& set : problem.sets) {
    for (const int e : set) covered[static_cast<std::size_t>(e)] = true;
  }
  const auto coverable = static_cast<double>(std::ranges::count(covered, true));
  return std::clamp((share * all - first) / coverable, 1e-6, 1.0);
}

}  // namespace

FloorBound FindFloorBound(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorCover& cover, const slam::Pose2& T_map_start,
                          const FloorScannerOptions& scanner, const FloorBoundOptions& options,
                          const Parallel& parallel) {
  const auto first = SeenPlaces(ViewFloor(floor, T_map_start, scanner), cover, scanner);
  const auto all = static_cast<double>(cover.places_map.size());
  FloorBound bound{{T_map_start}, 1, static_cast<double>(first.size()) / all};
  if (bound.covered >= options.cover.share) return bound;
  const std::vector<int> number = NumberRest(first, cover.places_map.size());
  const std::vector<Eigen::Vector2d> places = Thinned(reachable, options.place_spacing);
  std::vector<Surrounding> around(places.size());
  parallel.For(places.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    around[i] = LookAround(floor, places[i], cover, scanner);
  });
  CoverProblem problem;
  problem.weights.assign(cover.places_map.size() - first.size(), cover.length_each);
  const double half_view = 0.5 * slam::RadFromDeg(scanner.field_of_view);
  std::vector<slam::Pose2> views;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int h = 0; h < options.headings; ++h) {
      const double heading = slam::WrapAngle(2.0 * std::numbers::pi * h / options.headings);
      views.push_back({heading, places[i]});
      problem.sets.push_back(Within(around[i], heading, half_view, number));
    }
  }
  CoverOptions rest = options.cover;
  rest.share = RestShare(problem, static_cast<double>(first.size()), all, options.cover.share);
  const CoverResult result = MinimumCover(problem, rest);
  for (const std::size_t k : result.chosen) bound.views.push_back(views[k]);
  bound.lower_bound = 1 + result.lower_bound;
  bound.covered += result.covered / cover.length_each / all;
  return bound;
}

}  // namespace ariadne::experiments
