#include "slam/registration/map_scan.h"

#include <algorithm>

#include "slam/registration/correspondences.h"

namespace ariadne::slam {

std::size_t CountOverlap(const MapScan& model, const MapScan& data, double max_distance,
                         const Parallel& parallel) {
  const Pose3 T_model_data = model.T_map_laser.Inverse() * data.T_map_laser;
  const Correspondences pairs =
      FindByKdTree(model.tree_laser, data.points_laser.positions, T_model_data, max_distance, parallel);
  const auto unpaired = std::count(pairs.model_index.begin(), pairs.model_index.end(), kNoPoint);
  return pairs.model_index.size() - static_cast<std::size_t>(unpaired);
}

std::vector<std::size_t> FindOverlapping(const std::vector<MapScan>& scans, std::size_t current,
                                         std::size_t min_pairs, double max_distance,
                                         const Parallel& parallel) {
  std::vector<std::size_t> overlapping;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i == current || !scans[i].registered) continue;
    if (CountOverlap(scans[i], scans[current], max_distance, parallel) > min_pairs)
      overlapping.push_back(i);
  }
  return overlapping;
}

PointCloud UnionInMap(const std::vector<MapScan>& scans, const std::vector<std::size_t>& members) {
  PointCloud cloud_map;
  for (const std::size_t i : members)
    Append(cloud_map, Transformed(scans[i].T_map_laser, scans[i].points_laser));
  return cloud_map;
}

}  // namespace ariadne::slam
