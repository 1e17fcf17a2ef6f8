#pragma once

#include <span>

#include "slam/extract/line_segment.h"
#include "slam/scan/scan.h"

namespace ariadne::slam {

/// The returns of a sweep in the plane of the slice, in the order of the beams: from right to left, which
/// is anticlockwise. Beams without a return are left out.
std::vector<Eigen::Vector2d> SlicePoints(const ScannerModel& scanner, const LaserSweep& sweep);

/// The same for one slice of an organized cloud in the laser frame. Each point is turned about the tilt
/// axis into the plane by its own pitch, as the tilt may have moved on between two beams.
std::vector<Eigen::Vector2d> SlicePoints(const PointCloud& cloud_laser, std::size_t slice);

/// Neighbours of a slice that were joined into one point.
struct JoinedPoint {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();  // [m]
  std::size_t first = 0;
  std::size_t last = 0;  // included
};

/// The paper's reduced points of one slice (Sec. 2.2.1 step 1, as ReduceSlices): runs of points within
/// join_distance [m] of their first become their mean. With 0, only equal points are joined.
std::vector<JoinedPoint> JoinNeighbors(std::span<const Eigen::Vector2d> points, double join_distance);

}  // namespace ariadne::slam
