#include "slam/scan/point_cloud.h"

#include <algorithm>

namespace ariadne::slam {
namespace {

/// Attributes of a union: both clouds must have them, unless one has no points.
template <typename T>
void AppendAttribute(std::vector<T>& to, std::size_t to_points, const std::vector<T>& tail,
                     std::size_t tail_points) {
  const bool both = to.size() == to_points && tail.size() == tail_points;
  if (!both) to.clear();
  if (both) to.insert(to.end(), tail.begin(), tail.end());
}

}  // namespace

PointCloud Transformed(const Pose3& T_a_b, PointCloud cloud_b) {
  const Eigen::Matrix3d R = T_a_b.RotationMatrix();
  for (Eigen::Vector3d& p : cloud_b.positions) p = R * p + T_a_b.translation;
  for (Eigen::Vector3d& n : cloud_b.normals) n = R * n;
  return cloud_b;
}

PointCloud Selected(const PointCloud& cloud, const std::vector<std::size_t>& indices) {
  PointCloud selected;
  selected.positions.reserve(indices.size());
  for (const std::size_t i : indices) selected.positions.push_back(cloud.positions[i]);
  if (!cloud.reflectance.empty()) {
    for (const std::size_t i : indices) selected.reflectance.push_back(cloud.reflectance[i]);
  }
  if (!cloud.normals.empty()) {
    for (const std::size_t i : indices) selected.normals.push_back(cloud.normals[i]);
  }
  for (const std::size_t begin : cloud.slice_begin) {
    const auto first = std::lower_bound(indices.begin(), indices.end(), begin);
    selected.slice_begin.push_back(static_cast<std::size_t>(first - indices.begin()));
  }
  return selected;
}

PointCloud WithinRange(const PointCloud& cloud_laser, double min_range, double max_range) {
  std::vector<std::size_t> kept;
  kept.reserve(cloud_laser.size());
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    const double range = cloud_laser.positions[i].norm();
    if (range > min_range && range < max_range) kept.push_back(i);
  }
  return Selected(cloud_laser, kept);
}

void Append(PointCloud& cloud, const PointCloud& tail) {
  const std::size_t offset = cloud.size();
  const bool organized = (cloud.empty() || cloud.organized()) && (tail.empty() || tail.organized());
  AppendAttribute(cloud.reflectance, offset, tail.reflectance, tail.size());
  AppendAttribute(cloud.normals, offset, tail.normals, tail.size());
  if (!organized) cloud.slice_begin.clear();
  if (organized) {
    for (const std::size_t begin : tail.slice_begin) cloud.slice_begin.push_back(offset + begin);
  }
  cloud.positions.insert(cloud.positions.end(), tail.positions.begin(), tail.positions.end());
}

std::optional<std::size_t> FirstNonFinite(const PointCloud& cloud) {
  const auto found = std::find_if(cloud.positions.begin(), cloud.positions.end(),
                                  [](const Eigen::Vector3d& p) { return !p.allFinite(); });
  if (found == cloud.positions.end()) return std::nullopt;
  return static_cast<std::size_t>(found - cloud.positions.begin());
}

}  // namespace ariadne::slam
