#include "planning/path/forward_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <set>

#include "planning/path/curved_way.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

constexpr double kPlace = 0.1;  // [m]
constexpr int kHeadings = 48;
constexpr double kStep = 0.15;         // leaves the place, also on a diagonal [m]
constexpr double kJoinWithin = 6.0;    // length of the last piece [m]
constexpr double kNearGoal = 1.5;      // within which each pose is tried for it [m]
constexpr std::size_t kFarTries = 20;  // farther away one of so many is

/// Poses and what they were reached from; of each place and heading the first that comes.
class ForwardSearch {
 public:
  ForwardSearch(const GeodesicField& from_goal, const Footprint& footprint, const slam::Pose2& T_map_goal,
                double turning_radius, const IsForwardFree& is_free)
      : from_goal_(from_goal),
        footprint_(footprint),
        T_map_goal_(T_map_goal),
        radius_(turning_radius),
        is_free_(is_free) {}

  std::vector<slam::Pose2> Find(const slam::Pose2& T_map_start, std::size_t most);

 private:
  using Place = std::array<long, 3>;  // x, y, heading
  using Entry = std::pair<double, std::size_t>;
  struct Reached {
    slam::Pose2 pose;
    double way;  // to it [m]
    std::size_t before;
  };

  static Place PlaceOf(const slam::Pose2& pose) {
    const double turns = 0.5 * pose.angle / std::numbers::pi;
    const long heading = std::lround(turns * kHeadings);
    return {std::lround(pose.translation.x() / kPlace), std::lround(pose.translation.y() / kPlace),
            (heading + kHeadings) % kHeadings};
  }
  void Reach(const slam::Pose2& pose, double way, std::size_t before);
  bool Joins(const slam::Pose2& pose) const {
    return DubinsWay(pose, T_map_goal_, radius_).length() <= kJoinWithin && is_free_(pose, T_map_goal_);
  }
  std::vector<slam::Pose2> WayTo(std::size_t last) const;

  const GeodesicField& from_goal_;
  const Footprint& footprint_;
  const slam::Pose2& T_map_goal_;
  double radius_;
  const IsForwardFree& is_free_;
  std::vector<Reached> reached_;
  std::set<Place> places_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

void ForwardSearch::Reach(const slam::Pose2& pose, double way, std::size_t before) {
  const double left = from_goal_.To(footprint_.CentreAt(pose));
  if (std::isinf(left) || !places_.insert(PlaceOf(pose)).second) return;
  open_.emplace(way + left, reached_.size());
  reached_.push_back({pose, way, before});
}

std::vector<slam::Pose2> ForwardSearch::WayTo(std::size_t last) const {
  std::vector<slam::Pose2> corners{T_map_goal_, reached_[last].pose};
  for (std::size_t i = last; i != 0; i = reached_[i].before)
    corners.push_back(reached_[reached_[i].before].pose);
  std::ranges::reverse(corners);
  return corners;
}

std::vector<slam::Pose2> ForwardSearch::Find(const slam::Pose2& T_map_start, std::size_t most) {
  Reach(T_map_start, 0.0, 0);
  for (std::size_t n = 0; !open_.empty() && reached_.size() <= most; ++n) {
    const std::size_t i = open_.top().second;
    open_.pop();
    const Reached at = reached_[i];
    const double away = (at.pose.translation - T_map_goal_.translation).norm();
    if ((away < kNearGoal || n % kFarTries == 0) && Joins(at.pose)) return WayTo(i);
    for (const int turn : {0, 1, -1}) {
      const slam::Pose2 next = CurvedWay(at.pose, radius_, {{turn, kStep / radius_}}).At(1.0);
      if (!places_.contains(PlaceOf(next)) && is_free_(at.pose, next)) Reach(next, at.way + kStep, i);
    }
  }
  return {};
}

}  // namespace

std::vector<slam::Pose2> ForwardWay(const GeodesicField& from_goal, const Footprint& footprint,
                                    const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                    double turning_radius, const IsForwardFree& is_free, std::size_t most) {
  return ForwardSearch(from_goal, footprint, T_map_goal, turning_radius, is_free).Find(T_map_start, most);
}

}  // namespace ariadne::planning::internal
