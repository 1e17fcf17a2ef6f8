#pragma once

#include <vector>

#include "slam/base/parallel.h"
#include "slam/registration/map_scan.h"

namespace ariadne::experiments {

/// How well one scan lies on another: of the distances from its points to the nearest points of the other
/// that are within the gate.
struct PairResidual {
  std::size_t pairs = 0;
  double median = 0.0;  // [m]
  double rms = 0.0;     // [m]
};

PairResidual MeasureResidual(const slam::KdTree& model_laser,
                             const std::vector<Eigen::Vector3d>& data_laser,
                             const slam::Pose3& T_model_data, double max_distance,
                             const Parallel& parallel);

/// The residuals of two overlapping scans at the poses of the odometry, and at those of the map.
struct ResidualChange {
  std::size_t model = 0;
  std::size_t data = 0;
  PairResidual before;
  PairResidual after;
};

/// Of all pairs of scans that overlap in the map by more than min_pairs points.
std::vector<ResidualChange> MeasureResiduals(const std::vector<slam::MapScan>& scans,
                                             const std::vector<slam::Pose3>& T_odom_laser,
                                             std::size_t min_pairs, double max_distance,
                                             const Parallel& parallel);

}  // namespace ariadne::experiments
