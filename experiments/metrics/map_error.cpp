#include "experiments/metrics/map_error.h"

#include <algorithm>

#include "experiments/metrics/statistics.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kPointsPerChunk = 4096;

}  // namespace

slam::Pose3 PlaceByMaster(const slam::Pose3& T_map_master, const slam::Pose3& T_world_master) {
  return T_world_master * T_map_master.Inverse();
}

std::vector<double> SurfaceDistances(const std::vector<Eigen::Vector3d>& points_map,
                                     const slam::Pose3& T_world_map,
                                     const drivers::SurfaceDistance& surface, const Parallel& parallel) {
  std::vector<double> distances(points_map.size());
  parallel.For(points_map.size(), kPointsPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      distances[k] = surface.Closest(T_world_map * points_map[k]).distance;
  });
  return distances;
}

MapError MeasureMapError(const std::vector<Eigen::Vector3d>& points_map, const slam::Pose3& T_world_map,
                         const drivers::SurfaceDistance& surface, const MapErrorOptions& options,
                         const Parallel& parallel) {
  if (points_map.empty()) return {};
  std::vector<double> distances = SurfaceDistances(points_map, T_world_map, surface, parallel);
  std::sort(distances.begin(), distances.end());
  const auto within = std::upper_bound(distances.begin(), distances.end(), options.within);
  return {distances.size(),
          Mean(distances),
          QuantileOfSorted(distances, 0.5),
          Rms(distances),
          QuantileOfSorted(distances, 0.95),
          distances.back(),
          static_cast<double>(within - distances.begin()) / static_cast<double>(distances.size())};
}

}  // namespace ariadne::experiments
