#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// Points in one frame, which the name of the variable says: `cloud_laser`, `cloud_map`.
struct PointCloud {
  std::vector<Eigen::Vector3d> positions;  // [m]
  std::vector<float> reflectance;          // empty, or one per point; the unit is the device's
  std::vector<Eigen::Vector3d> normals;    // empty, or one per point; unit length
  std::vector<std::size_t> slice_begin;    // organized clouds: first point of each slice, ascending, from 0

  std::size_t size() const { return positions.size(); }
  bool empty() const { return positions.empty(); }
  bool organized() const { return !slice_begin.empty(); }
};

/// The same points in frame a.
PointCloud Transformed(const Pose3& T_a_b, PointCloud cloud_b);

/// The points with the given indices (ascending), with their attributes and slices.
PointCloud Selected(const PointCloud& cloud, const std::vector<std::size_t>& indices);

/// The points of a laser-frame cloud with min_range < |p| < max_range [m].
PointCloud WithinRange(const PointCloud& cloud_laser, double min_range, double max_range);

/// Appends `tail` to `cloud`. An attribute survives where both have it (or where one is empty).
void Append(PointCloud& cloud, const PointCloud& tail);

/// The first point with a coordinate that is NaN or infinite.
std::optional<std::size_t> FirstNonFinite(const PointCloud& cloud);

/// A scan's points with the pose of the laser that saw them.
struct PosedCloud {
  std::string name;
  PointCloud cloud_laser;
  Pose3 T_map_laser;
};

}  // namespace ariadne::slam
