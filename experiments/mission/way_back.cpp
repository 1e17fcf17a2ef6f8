#include "experiments/mission/way_back.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kSamePlace = 0.02;  // [m]
constexpr double kSameTurn = 0.15;   // turns for which there may be no room any more [rad]
constexpr double kCorrection = 0.2;  // sideways steps that are no longer are of the localization [m]
constexpr double kAlong = 0.5;       // sine of the angle to its heading that a robot drives at, at most
constexpr double kStood = 0.01;      // moved by less [m]
constexpr double kStoodTurn = 0.01;  // [rad]
constexpr std::size_t kLongest = 10'000;  // poses

double TurnBetween(const slam::Pose2& a, const slam::Pose2& b) {
  return std::abs(slam::WrapAngle(a.angle - b.angle));
}

/// Whether a robot may have driven a step, as it was turned at one end of it.
bool IsDriven(const slam::Pose2& from, const slam::Pose2& to) {
  const Eigen::Vector2d step = from.RotationMatrix().transpose() * (to.translation - from.translation);
  const double length = step.norm();
  return length >= kCorrection || (length >= kSamePlace && std::abs(step.y()) < kAlong * length);
}

}  // namespace

std::vector<slam::Pose2> WayBack(std::span<const slam::Pose2> driven_map, double reach) {
  if (driven_map.empty()) return {};
  std::vector<slam::Pose2> back{driven_map.back()};
  for (auto pose = driven_map.rbegin(); pose != driven_map.rend(); ++pose) {
    const auto same = std::ranges::find_if(back, [&](const slam::Pose2& other) {
      return (pose->translation - other.translation).norm() < kSamePlace &&
             TurnBetween(*pose, other) < kSameTurn;
    });
    if (same != back.end()) {
      back.erase(same + 1, back.end());
      continue;
    }
    slam::Pose2 next = *pose;
    if (!IsDriven(back.back(), next) && !IsDriven(next, back.back())) {
      if (TurnBetween(next, back.back()) < kSameTurn) continue;
      next.translation = back.back().translation;
    }
    back.push_back(next);
    if ((pose->translation - back.front().translation).norm() > reach) break;
  }
  return back;
}

void AddToTrail(std::span<const slam::Pose2> driven_map, std::vector<slam::Pose2>& trail_map) {
  for (std::size_t i = 0; i < driven_map.size(); ++i) {
    const slam::Pose2& pose = driven_map[i];
    const bool stood = !trail_map.empty() &&
                       (pose.translation - trail_map.back().translation).norm() < kStood &&
                       TurnBetween(pose, trail_map.back()) < kStoodTurn;
    if (!stood || i + 1 == driven_map.size()) trail_map.push_back(pose);
  }
  if (trail_map.size() > kLongest)
    trail_map.erase(trail_map.begin(), trail_map.end() - static_cast<std::ptrdiff_t>(kLongest));
}

}  // namespace ariadne::experiments
