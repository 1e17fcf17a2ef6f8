#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "slam/search/kd_tree.h"

/// The definition of the nearest neighbour, as slowly as it is written.
namespace ariadne::slam {

/// All points by their distance to the query, of equally near ones the lower index first.
inline std::vector<Neighbor> AllByDistance(const std::vector<Eigen::Vector3d>& points,
                                           const Eigen::Vector3d& query) {
  std::vector<Neighbor> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all.push_back({static_cast<std::uint32_t>(i), SquaredDistance(points[i], query)});
  }
  std::ranges::stable_sort(all, {}, &Neighbor::squared_distance);
  return all;
}

/// The nearest point that is closer than the gate [m].
inline Neighbor NearestOfAll(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& query,
                             double max_distance) {
  Neighbor nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = SquaredDistance(points[i], query);
    if (squared < max_distance * max_distance && squared < nearest.squared_distance) {
      nearest = {static_cast<std::uint32_t>(i), squared};
    }
  }
  return nearest;
}

}  // namespace ariadne::slam
