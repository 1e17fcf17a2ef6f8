#pragma once

#include <Eigen/Core>
#include <vector>

#include "drivers/simulated/surface_distance.h"
#include "slam/base/parallel.h"
#include "slam/geometry/pose3.h"

namespace ariadne::experiments {

/// T_world_map: where a map lies in the true world, if its master scan lies where it truly was. Nothing is
/// fitted: an error of the other scans cannot be shared out over all.
slam::Pose3 PlaceByMaster(const slam::Pose3& T_map_master, const slam::Pose3& T_world_master);

/// Distances d_k = min |T_world_map p_k - s| over all points s of the true surfaces, of the points p_k of a
/// map. They hold the scanner's own errors too: the same of the scans at their true poses is the least that
/// a registration can reach. Points on bodies that move count as errors.
struct MapError {
  std::size_t points = 0;
  double mean = 0.0;    // [m]
  double median = 0.0;  // [m]
  double rms = 0.0;     // [m]
  double percentile_95 = 0.0;
  double max = 0.0;           // [m]
  double share_within = 0.0;  // of the points with d_k <= within
};

struct MapErrorOptions {
  double within = 0.02;  // [m]
};

MapError MeasureMapError(const std::vector<Eigen::Vector3d>& points_map, const slam::Pose3& T_world_map,
                         const drivers::SurfaceDistance& surface, const MapErrorOptions& options,
                         const Parallel& parallel);

/// The distances d_k themselves, for pictures. [m]
std::vector<double> SurfaceDistances(const std::vector<Eigen::Vector3d>& points_map,
                                     const slam::Pose3& T_world_map,
                                     const drivers::SurfaceDistance& surface, const Parallel& parallel);

}  // namespace ariadne::experiments
