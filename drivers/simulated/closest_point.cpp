#include "drivers/simulated/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace ariadne::drivers {
namespace {

Eigen::Vector3d ClosestOnSegment(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 const Eigen::Vector3d& p) {
  const Eigen::Vector3d along = to - from;
  const double squared_length = along.squaredNorm();
  if (squared_length == 0.0) return from;
  return from + std::clamp((p - from).dot(along) / squared_length, 0.0, 1.0) * along;
}

}  // namespace

Eigen::Vector3d ClosestPoint(const Triangle& triangle, const Eigen::Vector3d& p) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double squared_length = normal.squaredNorm();
  const auto inside_of = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(p - from)) >= 0.0;
  };
  if (squared_length > 0.0 && inside_of(a, b) && inside_of(b, c) && inside_of(c, a))
    return p - normal * (normal.dot(p - a) / squared_length);
  Eigen::Vector3d closest = ClosestOnSegment(a, b, p);
  for (const Eigen::Vector3d& candidate : {ClosestOnSegment(b, c, p), ClosestOnSegment(c, a, p)}) {
    if ((candidate - p).squaredNorm() < (closest - p).squaredNorm()) closest = candidate;
  }
  return closest;
}

}  // namespace ariadne::drivers
