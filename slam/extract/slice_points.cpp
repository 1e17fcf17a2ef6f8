#include "slam/extract/slice_points.h"

#include "slam/base/error.h"

namespace ariadne::slam {

std::vector<Eigen::Vector2d> SlicePoints(const ScannerModel& scanner, const LaserSweep& sweep) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(sweep.ranges.size());
  for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
    const double range = sweep.ranges[beam];
    if (std::isnan(range)) continue;
    const double angle = scanner.first_angle + static_cast<double>(beam) * scanner.angle_step;
    points.emplace_back(range * std::sin(angle), -range * std::cos(angle));
  }
  return points;
}

std::vector<Eigen::Vector2d> SlicePoints(const PointCloud& cloud_laser, std::size_t slice) {
  const std::vector<std::size_t>& begins = cloud_laser.slice_begin;
  if (slice >= begins.size()) {
    Fail("there is no slice {} in a cloud of {} slices", slice, begins.size());
  }
  const std::size_t end = slice + 1 < begins.size() ? begins[slice + 1] : cloud_laser.size();
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = begins[slice]; i < end; ++i) {
    const Eigen::Vector3d& p = cloud_laser.positions[i];
    points.emplace_back(std::hypot(p.x(), p.z()), p.y());
  }
  return points;
}

std::vector<JoinedPoint> JoinNeighbors(std::span<const Eigen::Vector2d> points, double join_distance) {
  std::vector<JoinedPoint> joined;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool near = !joined.empty() && (points[i] - points[joined.back().first]).norm() <= join_distance;
    if (!near) joined.push_back({Eigen::Vector2d::Zero(), i, i});
    joined.back().mean += points[i];
    joined.back().last = i;
  }
  for (JoinedPoint& point : joined) point.mean /= static_cast<double>(point.last - point.first + 1);
  return joined;
}

}  // namespace ariadne::slam
