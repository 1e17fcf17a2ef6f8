#include "experiments/metrics/reachable.h"

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 2>;  // steps from the start

constexpr std::array<Cell, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// What rays tell of a place.
class Prober {
 public:
  Prober(const drivers::RayScene& scene, const ReachableOptions& options) : scene_(scene), o_(options) {}

  bool IsFree(const Vector3d& place) const {
    return HasFloor(place) && !HitsWithin(place, Vector3d::UnitZ(), o_.highest, o_.lowest) &&
           IsClear(place);
  }

  /// No surface between the two places, which are one step apart.
  bool IsOpen(const Vector3d& from, const Vector3d& to) const {
    const Vector3d step = to - from;
    for (int i = 0; i < o_.heights; ++i) {
      if (HitsWithin(from, step.normalized(), step.norm(), Height(i))) return false;
    }
    return true;
  }

 private:
  double Height(int i) const {
    return o_.heights == 1 ? o_.lowest : std::lerp(o_.lowest, o_.highest, double(i) / (o_.heights - 1));
  }

  bool HitsWithin(const Vector3d& place, const Vector3d& direction, double distance, double height) const {
    return scene_.Cast({place + height * Vector3d::UnitZ(), direction, 0.0}).distance < distance;
  }

  bool HasFloor(const Vector3d& place) const {
    const double drop =
        scene_.Cast({place + o_.highest * Vector3d::UnitZ(), -Vector3d::UnitZ(), 0.0}).distance;
    return std::abs(drop - o_.highest) <= o_.floor_tolerance;
  }

  bool IsClear(const Vector3d& place) const {
    for (int i = 0; i < o_.heights; ++i) {
      for (int k = 0; k < o_.directions; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / o_.directions;
        const Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
        if (HitsWithin(place, direction, o_.radius, Height(i))) return false;
      }
    }
    return true;
  }

  const drivers::RayScene& scene_;
  const ReachableOptions& o_;
};

}  // namespace

std::vector<Vector3d> ReachablePlaces(const drivers::RayScene& scene, const ReachableOptions& options) {
  const Prober prober(scene, options);
  const Eigen::Vector2d start = scene.world().T_map_start.translation;
  const auto place_of = [&](const Cell& cell) {
    return Vector3d(start.x() + cell[0] * options.step, start.y() + cell[1] * options.step, 0.0);
  };
  std::vector<Cell> reached{{0, 0}};
  std::set<Cell> seen{{0, 0}};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    if (reached.size() > options.max_places)
      Fail("{}: more than {} places can be reached: the world has no bounds", scene.world().name,
           options.max_places);
    const Cell here = reached[next];
    for (const Cell& step : kSteps) {
      const Cell there{here[0] + step[0], here[1] + step[1]};
      if (seen.contains(there) || !prober.IsOpen(place_of(here), place_of(there))) continue;
      seen.insert(there);
      if (prober.IsFree(place_of(there))) reached.push_back(there);
    }
  }
  std::vector<Vector3d> places;
  for (const Cell& cell : reached) places.push_back(place_of(cell));
  return places;
}

std::vector<Vector3d> ViewpointsAbove(const std::vector<Vector3d>& places, double spacing, double height) {
  std::set<Cell> seen;
  std::vector<Vector3d> viewpoints;
  for (const Vector3d& place : places) {
    const Cell square{static_cast<int>(std::floor(place.x() / spacing)),
                      static_cast<int>(std::floor(place.y() / spacing))};
    if (seen.insert(square).second) viewpoints.push_back(place + height * Vector3d::UnitZ());
  }
  return viewpoints;
}

}  // namespace ariadne::experiments
