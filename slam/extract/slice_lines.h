#pragma once

#include <cstddef>
#include <vector>

#include "slam/extract/detect_lines.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A line of a slice where it is in space. The scanner at the origin sees it run from its right to its
/// left.
struct SpatialLine {
  Eigen::Vector3d from_laser = Eigen::Vector3d::Zero();  // right end [m]
  Eigen::Vector3d to_laser = Eigen::Vector3d::Zero();    // left end [m]
  double rms = 0.0;                                      // distance of the points within the slice [m]
  std::size_t slice = 0;
  std::size_t points = 0;                        // that it explains
  std::vector<Eigen::Vector3d> explained_laser;  // those points, in the order of the beams [m]

  double Length() const { return (to_laser - from_laser).norm(); }
};

/// The lines of one slice of an organized cloud, in the order of the beams. Each point is turned about the
/// tilt axis into the plane of the slice, and each end back by the pitch of the point that is the end, as
/// the tilt may move on within a slice. Error as SlicePoints and DetectLines.
std::vector<SpatialLine> SpatialLines(const PointCloud& cloud_laser, std::size_t slice,
                                      const LineOptions& options);

/// The lines of each slice. Error where the cloud is not organized.
std::vector<std::vector<SpatialLine>> SliceLines(const PointCloud& cloud_laser, const LineOptions& options);

/// The edge points of a scan (Sec. 3.3, Fig. 5): the ends of all lines, slice by slice, as an organized
/// cloud with a slice for each of the scan's, which may be empty. Error where the cloud is not organized.
PointCloud EdgePointCloud(const PointCloud& cloud_laser, const LineOptions& options);

/// Throws an Error that says what `purpose` needs slices for, and how a cloud comes by them.
void RequireSlices(const PointCloud& cloud_laser, std::string_view purpose);

}  // namespace ariadne::slam
