#pragma once

#include <string>

#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

/// What `ariadne info` tells of a scan.
struct ScanStatistics {
  std::size_t points = 0;
  std::size_t slices = 0;  // 0: not organized
  bool has_reflectance = false;
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();  // of the bounding box [m]
  double min_range = 0.0;                            // from the laser [m]
  double median_range = 0.0;
  double max_range = 0.0;
  double median_spacing = 0.0;  // distance from a point to its nearest neighbour [m]
  std::string suspicious;       // a list in words of what is probably no measurement; empty: nothing
};

ScanStatistics MeasureScan(const slam::PointCloud& cloud_laser);

}  // namespace ariadne::experiments
