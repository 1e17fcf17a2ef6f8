#include "drivers/simulated/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ariadne::drivers {
namespace {

/// A convex polygon in space on its way through the cuts.
struct Corners {
  std::array<Eigen::Vector3d, 5> at;
  std::size_t count = 0;

  void Add(const Eigen::Vector3d& p) { at[count++] = p; }
};

/// The part where sign * (z - height) >= 0 (Sutherland and Hodgman, for one plane).
Corners Cut(const Corners& corners, double height, double sign) {
  Corners kept;
  for (std::size_t i = 0; i < corners.count; ++i) {
    const Eigen::Vector3d& p = corners.at[i];
    const Eigen::Vector3d& q = corners.at[(i + 1) % corners.count];
    const double above_p = sign * (p.z() - height), above_q = sign * (q.z() - height);
    if (above_p >= 0.0) kept.Add(p);
    if ((above_p > 0.0 && above_q < 0.0) || (above_p < 0.0 && above_q > 0.0)) {
      kept.Add(p + (above_p / (above_p - above_q)) * (q - p));
    }
  }
  return kept;
}

/// How far the outline reaches into the rectangle along a unit axis; not positive where it does not.
double DepthAlong(const Eigen::Vector2d& axis, std::span<const Eigen::Vector2d> corners,
                  const Eigen::Vector2d& half_size) {
  const double reach = axis.cwiseAbs().dot(half_size);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& corner : corners) {
    const double along = axis.dot(corner);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  return std::min(high + reach, reach - low);
}

}  // namespace

Outline OutlineBetween(const std::array<Eigen::Vector3d, 3>& triangle, const HeightRange& heights) {
  Corners corners;
  for (const Eigen::Vector3d& p : triangle) corners.Add(p);
  corners = Cut(Cut(corners, heights.low, 1.0), heights.high, -1.0);
  Outline outline;
  for (std::size_t i = 0; i < corners.count; ++i) outline.Add(corners.at[i].head<2>());
  return outline;
}

double OverlapDepth(const Outline& outline_map, const slam::Pose2& T_map_base,
                    const Eigen::Vector2d& half_size) {
  if (outline_map.empty()) return 0.0;
  const slam::Pose2 T_base_map = T_map_base.Inverse();
  Outline outline_base;
  for (const Eigen::Vector2d& corner : outline_map.corners()) outline_base.Add(T_base_map * corner);
  const auto corners = outline_base.corners();

  double depth = std::min(DepthAlong(Eigen::Vector2d::UnitX(), corners, half_size),
                          DepthAlong(Eigen::Vector2d::UnitY(), corners, half_size));
  for (std::size_t i = 0; i < corners.size() && depth > 0.0; ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i];
    const double length = edge.norm();
    if (length == 0.0) continue;
    depth = std::min(depth, DepthAlong(Eigen::Vector2d(-edge.y(), edge.x()) / length, corners, half_size));
  }
  return std::max(depth, 0.0);
}

double DistanceTo(const Outline& outline_map, const Eigen::Vector2d& p_map) {
  const auto corners = outline_map.corners();
  double nearest = std::numeric_limits<double>::infinity();
  bool on_left = false, on_right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i], p = p_map - corners[i];
    const double squared_length = edge.squaredNorm();
    const double share = squared_length > 0.0 ? std::clamp(edge.dot(p) / squared_length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (p - share * edge).norm());
    const double side = edge.x() * p.y() - edge.y() * p.x();
    on_left = on_left || side > 0.0;
    on_right = on_right || side < 0.0;
  }
  return on_left != on_right ? 0.0 : nearest;
}

}  // namespace ariadne::drivers
