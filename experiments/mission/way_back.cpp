#include "experiments/mission/way_back.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kSamePlace = 0.02;  // [m]
constexpr double kSameTurn = 0.15;   // turns for which there may be no room any more [rad]

}  // namespace

std::vector<slam::Pose2> WayBack(std::span<const slam::Pose2> driven_map, double reach) {
  if (driven_map.empty()) return {};
  std::vector<slam::Pose2> back{driven_map.back()};
  for (auto pose = driven_map.rbegin(); pose != driven_map.rend(); ++pose) {
    const auto same = std::ranges::find_if(back, [&](const slam::Pose2& other) {
      return (pose->translation - other.translation).norm() < kSamePlace &&
             std::abs(slam::WrapAngle(pose->angle - other.angle)) < kSameTurn;
    });
    if (same != back.end()) {
      back.erase(same + 1, back.end());
      continue;
    }
    back.push_back(*pose);
    if ((pose->translation - back.front().translation).norm() > reach) break;
  }
  return back;
}

}  // namespace ariadne::experiments
