#pragma once

#include <vector>

#include "slam/base/parallel.h"
#include "slam/matching/map_scan.h"

namespace ariadne::experiments {

/// How well one scan lies on another (whose surfaces are estimated), by its points whose nearest point of
/// the other is within the gate.
struct PairResidual {
  std::size_t pairs = 0;
  double median = 0.0;  // of the distances between the points; the spacing of the points is its floor [m]
  double plane_median =
      0.0;  // of the distances to the other's surface at its point, where it has a normal [m]
  double plane_rms = 0.0;  // of the same [m]
};

PairResidual MeasureResidual(const slam::MapScan& model, const slam::MapScan& data,
                             const slam::Pose3& T_model_data, double max_distance,
                             const Parallel& parallel);

/// The residuals of two overlapping scans at the poses of the odometry, and at those of the map.
struct ResidualChange {
  std::size_t model = 0;
  std::size_t data = 0;
  PairResidual before;
  PairResidual after;
};

struct ResidualOptions {
  std::size_t min_pairs = 250;  // two scans with more pairs than this overlap
  double max_distance = 0.5;    // the gate [m]
};

/// Of all pairs of scans that overlap in the map.
std::vector<ResidualChange> MeasureResiduals(const std::vector<slam::MapScan>& scans,
                                             const std::vector<slam::Pose3>& T_odom_laser,
                                             const ResidualOptions& options, const Parallel& parallel);

}  // namespace ariadne::experiments
