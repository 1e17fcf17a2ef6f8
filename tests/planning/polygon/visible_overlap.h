#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "planning/polygon/scan_polygon.h"
#include "slam/base/random.h"

/// Polygons of simulated scans against what can be seen from where they were taken.
namespace ariadne::planning {

constexpr double kSightHeight = 1.5;  // [m]
constexpr double kSight = 15.0;       // the range of the paper's rays: nothing counts beyond [m]

/// How far a ray from p inside the polygon goes to its first edge; 0 where there is none.
inline double RangeWithin(const LabelledPolygon& polygon, const Eigen::Vector2d& p, double bearing) {
  const Eigen::Vector2d u(std::cos(bearing), std::sin(bearing));
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    const Eigen::Vector2d a = polygon.outer[i].p_map - p;
    const Eigen::Vector2d e = polygon.outer[(i + 1) % polygon.outer.size()].p_map - p - a;
    const double across = u.x() * e.y() - u.y() * e.x();
    if (std::abs(across) < 1e-12) continue;
    const double range = (a.x() * e.y() - a.y() * e.x()) / across;
    const double share = (a.x() * u.y() - a.y() * u.x()) / across;
    if (share >= 0.0 && share <= 1.0 && range > 1e-6) nearest = std::min(nearest, range);
  }
  return std::isfinite(nearest) ? nearest : 0.0;
}

inline double TrueRange(const drivers::RayScene& scene, const Eigen::Vector2d& p, double bearing) {
  const Eigen::Vector3d u(std::cos(bearing), std::sin(bearing), 0.0);
  return std::min(scene.Cast({{p.x(), p.y(), kSightHeight}, u}).distance, kSight);
}

/// Intersection over union of a polygon with what can be seen in the 180 degrees ahead, rays 0.1 degrees
/// apart.
inline double OverlapWithVisible(const LabelledPolygon& polygon, const drivers::RayScene& scene,
                                 const slam::Pose2& T_map_scan) {
  double common = 0.0, either = 0.0;
  for (int i = 0; i < 1800; ++i) {
    const double bearing = T_map_scan.angle + ((i + 0.5) / 1800.0 - 0.5) * std::numbers::pi;
    const double truth = TrueRange(scene, T_map_scan.translation, bearing);
    const double shown = std::min(RangeWithin(polygon, T_map_scan.translation, bearing), kSight);
    common += std::pow(std::min(truth, shown), 2);
    either += std::pow(std::max(truth, shown), 2);
  }
  return common / either;
}

/// Places that are reached from the start in straight lines, 0.5 m from what is ahead, and headings.
inline std::vector<slam::Pose2> DrawViews(RandomStream& stream, const drivers::RayScene& scene, int count) {
  Eigen::Vector2d p = scene.world().T_map_start.translation;
  std::vector<slam::Pose2> views;
  while (views.size() < static_cast<std::size_t>(count)) {
    const double bearing = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
    const double free = TrueRange(scene, p, bearing) - 0.5;
    if (free < 0.5) continue;
    const double way = DrawUniform(stream, 0.0, free);
    p += way * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    views.push_back({DrawUniform(stream, -std::numbers::pi, std::numbers::pi), p});
  }
  return views;
}

/// One horizontal sweep at the height of the slice.
inline slam::PosedCloud SweepAt(const drivers::RayScene& scene, const slam::Pose2& T_map_scan,
                                drivers::AisScannerOptions options, std::uint64_t number) {
  options.mount_x = 0.0;
  options.mount_z = kSightHeight;
  const slam::Pose3 T_map_base = slam::ToPose3(T_map_scan);
  slam::Scan scan;
  scan.scanner = drivers::AisMounting(options).scanner;
  scan.sweeps.push_back(
      drivers::TakeAisSweep(scene, drivers::Standing(T_map_base), 0.0, options, 1, number));
  slam::Pose3 T_map_laser = T_map_base;
  T_map_laser.translation.z() += kSightHeight;
  return {"view", slam::ToPointCloud(scan), T_map_laser};
}

}  // namespace ariadne::planning
