#include "slam/matching/map_scan.h"

#include <algorithm>

#include "slam/registration/pair_filter.h"

namespace ariadne::slam {

std::size_t CountPairs(const Correspondences& pairs, const MapScan& model, const MapScan& data,
                       const Pose3& T_model_data, bool one_sided) {
  const Eigen::Matrix3d R_model_data = T_model_data.RotationMatrix();
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs.model_index.size(); ++i) {
    const std::uint32_t m = pairs.model_index[i];
    if (m == kNoPoint) continue;
    const bool opposite =
        one_sided && AreOpposite(model.surfaces_laser[m], data.surfaces_laser[i], R_model_data);
    count += opposite ? 0 : 1;
  }
  return count;
}

std::size_t CountOverlap(const MapScan& model, const MapScan& data, double max_distance,
                         const Parallel& parallel, bool one_sided) {
  const Pose3 T_model_data = model.T_map_laser.Inverse() * data.T_map_laser;
  const Correspondences pairs =
      FindByKdTree(model.tree_laser, data.points_laser.positions, T_model_data, max_distance, parallel);
  return CountPairs(pairs, model, data, T_model_data, one_sided);
}

std::vector<std::size_t> FindOverlapping(const std::vector<MapScan>& scans, std::size_t current,
                                         std::size_t min_pairs, double max_distance,
                                         const Parallel& parallel, bool one_sided) {
  std::vector<std::size_t> overlapping;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i == current || !scans[i].registered) continue;
    if (CountOverlap(scans[i], scans[current], max_distance, parallel, one_sided) > min_pairs)
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
