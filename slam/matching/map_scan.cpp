#include "slam/matching/map_scan.h"

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

void RequireSurfaces(MapScan& scan, int neighbors, const Parallel& parallel) {
  if (scan.surfaces_laser.empty())
    scan.surfaces_laser = EstimateSurfaces(scan.tree_laser, neighbors, parallel);
}

AlignModel UnionInMap(const std::vector<MapScan>& scans, const std::vector<std::size_t>& members) {
  std::vector<Eigen::Vector3d> points_map;
  std::vector<SurfacePoint> surfaces_map;
  for (const std::size_t i : members) {
    const Eigen::Matrix3d R = scans[i].T_map_laser.RotationMatrix();
    for (const Eigen::Vector3d& p : scans[i].points_laser.positions) {
      points_map.push_back(R * p + scans[i].T_map_laser.translation);
    }
    for (SurfacePoint surface : scans[i].surfaces_laser) {
      surface.normal = R * surface.normal;
      surfaces_map.push_back(surface);
    }
  }
  if (surfaces_map.size() != points_map.size()) surfaces_map.clear();  // not every member has them
  return {KdTree(std::move(points_map)), std::move(surfaces_map)};
}

}  // namespace ariadne::slam
