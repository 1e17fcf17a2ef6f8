#include <algorithm>
#include <cmath>
#include <optional>

#include "drivers/simulated/floor_plan.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector2d;
constexpr double kSame =
    0.005;  // ends and lines as near as that are the same: plans are traced to centimetres [m]

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool IsOnLine(const PlanWall& wall, const Vector2d& p) {
  return std::abs(Cross(wall.direction(), p - wall.from)) < kSame;
}

/// Joins `more` to the wall if both lie on one line and touch.
bool Extend(PlanWall& wall, const PlanWall& more) {
  if (!IsOnLine(wall, more.from) || !IsOnLine(wall, more.to)) return false;
  const Vector2d u = wall.direction();
  double low = u.dot(more.from - wall.from), high = u.dot(more.to - wall.from);
  if (low > high) std::swap(low, high);
  if (low > wall.length() + kSame || high < -kSame) return false;
  const Vector2d from = wall.from;
  wall.to = from + std::max(high, wall.length()) * u;
  wall.from = from + std::min(low, 0.0) * u;
  return true;
}

constexpr double kNarrowest = 0.5, kWidest = 3.0;  // of a doorway [m]
constexpr double kBeside = 0.35;                   // a door's point from the line of its doorway [m]
constexpr double kAside = 0.2;  // so far may the walls on either side of a door be out of line [m]

/// Where a wall stands in the way of a ray: its nearer end where it leads on in about the ray's line.
std::optional<Vector2d> Opposite(const PlanWall& wall, const Vector2d& origin, const Vector2d& direction) {
  const Vector2d along = wall.to - wall.from, to_wall = wall.from - origin;
  const double sine = Cross(direction, along);
  if (std::abs(sine) < 0.15 * along.norm()) {
    const Vector2d end = direction.dot(along) > 0.0 ? wall.from : wall.to;
    if (std::abs(Cross(direction, end - origin)) > kAside) return std::nullopt;
    return end;
  }
  const double share = Cross(to_wall, direction) / sine, margin = 0.05 / along.norm();
  if (share < -margin || share > 1.0 + margin) return std::nullopt;
  return origin + (Cross(to_wall, along) / sine) * direction;
}

/// The doorway that begins where a wall ends, if a door lies in it.
std::optional<PlanWall> DoorwayAt(const Vector2d& end, const Vector2d& onward,
                                  const std::vector<PlanWall>& walls, const std::vector<Vector2d>& doors) {
  PlanWall doorway{end, end + 2.0 * kWidest * onward};
  for (const PlanWall& wall : walls) {
    const std::optional<Vector2d> opposite = Opposite(wall, end, onward);
    if (!opposite || onward.dot(*opposite - end) < kSame) continue;
    if ((*opposite - end).norm() < doorway.length()) doorway.to = *opposite;
  }
  if (doorway.length() < kNarrowest || doorway.length() > kWidest) return std::nullopt;
  const bool has_door = std::ranges::any_of(doors, [&](const Vector2d& door) {
    const double along = doorway.direction().dot(door - end);
    return along > 0.2 && along < doorway.length() - 0.2 &&
           std::abs(Cross(doorway.direction(), door - end)) < kBeside;
  });
  return has_door ? std::optional(doorway) : std::nullopt;
}

}  // namespace

bool IsInside(const std::vector<Vector2d>& outline, const Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vector2d &a = outline[i], &b = outline[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<PlanWall> MergeWalls(const std::vector<PlanWall>& walls) {
  std::vector<PlanWall> merged;
  for (PlanWall wall : walls) {
    if (wall.length() < kSame) continue;
    // A longer wall may touch others that it did not touch before.
    for (auto other = merged.begin(); other != merged.end();) {
      if (!Extend(wall, *other)) {
        ++other;
      } else {
        merged.erase(other);
        other = merged.begin();
      }
    }
    merged.push_back(wall);
  }
  return merged;
}

std::vector<PlanWall> FindDoorways(const std::vector<PlanWall>& walls, const std::vector<Vector2d>& doors) {
  std::vector<PlanWall> doorways;
  for (const PlanWall& wall : walls) {
    for (const bool at_end : {false, true}) {
      const Vector2d onward = at_end ? wall.direction() : Vector2d(-wall.direction());
      const auto doorway = DoorwayAt(at_end ? wall.to : wall.from, onward, walls, doors);
      if (doorway) doorways.push_back(*doorway);
    }
  }
  return MergeWalls(doorways);  // each is found from both of its sides
}

bool LeadsOutside(const PlanWall& doorway, const std::vector<PlanSpace>& spaces) {
  constexpr double kStep = 0.5;  // through the thickest wall [m]
  const Vector2d u = doorway.direction(), middle = 0.5 * (doorway.from + doorway.to);
  const auto in_no_space = [&](const Vector2d& p) {
    return std::ranges::none_of(spaces, [&](const PlanSpace& space) { return IsInside(space.outline, p); });
  };
  const Vector2d step = kStep * Vector2d(-u.y(), u.x());
  return !spaces.empty() && (in_no_space(middle + step) || in_no_space(middle - step));
}

}  // namespace ariadne::drivers
