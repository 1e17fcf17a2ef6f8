#include "experiments/exploration/floor_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/bounds/shortest_tour.h"
#include "planning/path/geodesic.h"
#include "slam/base/error.h"
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

/// What of the surrounding is within the field of view.
std::vector<int> Within(const Surrounding& around, double heading, double half_view) {
  std::vector<int> within;
  for (std::size_t i = 0; i < around.places.size(); ++i) {
    if (std::abs(slam::WrapAngle(around.bearings[i] - heading)) > half_view) continue;
    within.push_back(static_cast<int>(around.places[i]));
  }
  return within;
}

/// Which share of what the sets cover makes up a share of everything.
double ShareOfCoverable(const CoverProblem& problem, double share) {
  std::vector<bool> covered(problem.weights.size(), false);
  for (const auto& set : problem.sets) {
    for (const int e : set) covered[static_cast<std::size_t>(e)] = true;
  }
  const auto coverable = static_cast<double>(std::ranges::count(covered, true));
  return std::min(1.0, share * static_cast<double>(covered.size()) / coverable);
}

}  // namespace

FloorBound FindFloorBound(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorCover& cover, const planning::FreeSpace& free,
                          const FloorScannerOptions& scanner, const FloorBoundOptions& options,
                          const Parallel& parallel) {
  const std::vector<Eigen::Vector2d> places = Thinned(reachable, options.place_spacing);
  std::vector<Surrounding> around(places.size());
  parallel.For(places.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    around[i] = LookAround(floor, places[i], cover, scanner);
  });
  CoverProblem problem;
  problem.weights.assign(cover.places_map.size(), cover.length_each);
  const double half_view = 0.5 * slam::RadFromDeg(scanner.field_of_view);
  std::vector<slam::Pose2> views;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int h = 0; h < options.headings; ++h) {
      const double heading = slam::WrapAngle(2.0 * std::numbers::pi * h / options.headings);
      views.push_back({heading, places[i]});
      problem.sets.push_back(Within(around[i], heading, half_view));
    }
  }
  CoverOptions search = options.cover;
  search.share = ShareOfCoverable(problem, options.cover.share);
  const CoverResult result = MinimumCover(problem, search);
  FloorBound bound;
  for (const std::size_t k : result.chosen) bound.views.push_back(views[k]);
  bound.lower_bound = result.lower_bound;
  bound.covered = result.covered / cover.length_each / static_cast<double>(cover.places_map.size());
  bound.ways_to = WaysBetween(bound.views, free, options.robot_radius);
  return bound;
}

Eigen::MatrixXd WaysBetween(const std::vector<slam::Pose2>& views, const planning::FreeSpace& free,
                            double robot_radius) {
  const auto n = static_cast<Eigen::Index>(views.size());
  Eigen::MatrixXd ways = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto from =
        planning::DistancesFrom(free, views[static_cast<std::size_t>(i)].translation, robot_radius);
    for (Eigen::Index k = 0; k < i; ++k) {
      ways(i, k) = ways(k, i) = from.To(views[static_cast<std::size_t>(k)].translation);
    }
  }
  return ways;
}

double TourLength(const FloorBound& bound, const Eigen::Vector2d& start, const planning::FreeSpace& free,
                  double robot_radius) {
  const Eigen::Index n = bound.ways_to.rows();
  Eigen::MatrixXd ways = Eigen::MatrixXd::Zero(n + 1, n + 1);
  ways.bottomRightCorner(n, n) = bound.ways_to;
  const auto from = planning::DistancesFrom(free, start, robot_radius);
  for (Eigen::Index i = 0; i < n; ++i) {
    ways(0, i + 1) = ways(i + 1, 0) = from.To(bound.views[static_cast<std::size_t>(i)].translation);
  }
  if (!ways.allFinite()) Fail("a tour through all views of the bound leads through no known space");
  return ShortestTour(ways, 0).length;
}

planning::FreeSpace FreeFloor(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                              const FloorScannerOptions& scanner, double place_spacing) {
  FloorScannerOptions around = scanner;
  around.field_of_view = 360.0;
  std::vector<slam::Polygon2> seen;
  for (const Eigen::Vector2d& p : Thinned(reachable, place_spacing)) {
    seen.push_back(planning::ToPolygon2(ViewFloor(floor, {0.0, p}, around).polygon));
  }
  return planning::FreeSpace(slam::United(seen));
}

}  // namespace ariadne::experiments
