#pragma once

#include <malloc.h>

#include <vector>

#include "slam/scan/point_cloud.h"

namespace ariadne::bench {

/// A scan of a tour, in map coordinates, and where the laser was.
struct TourScan {
  slam::PointCloud cloud_map;
  Eigen::Vector3d viewpoint_map;
};

/// Scans of 181 x 256 points every 2 m along the corridor of builtin:robobench, with all noise. Made once.
const std::vector<TourScan>& CorridorTour();

/// Edge of the leaves of all octrees that are compared [m].
inline constexpr double kLeafSize = 0.05;

/// What the program has allocated, as malloc counts it: with its own overhead per piece [B].
inline double AllocatedBytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace ariadne::bench
