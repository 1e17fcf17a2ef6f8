#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A scan as rows of neighbouring beams, made from what is left of it in an organized cloud: beams without
/// a return are missing there, and neighbours are found again by their bearing.
struct ScanGrid {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Beam {
    Eigen::Vector3d direction_laser;  // unit length
    double range = 0.0;               // [m]
    double bearing = 0.0;             // within the slice, from the right (-y) anticlockwise [rad]
    double pitch = 0.0;               // of the slice plane, turned about y [rad]
    std::size_t right = kNone;  // neighbours in the slice, kNone where a beam next to it has no return
    std::size_t left = kNone;
    std::size_t before = kNone;  // nearest in bearing of the slice before and after
    std::size_t after = kNone;
  };

  std::vector<Beam> beams;                       // as the points of the cloud
  std::vector<std::vector<std::size_t>> slices;  // its beams from right to left
  double bearing_step = 0.0;                     // median between neighbours of a slice [rad]
  double pitch_step = 0.0;                       // median between slices [rad]
};

/// Beams further apart in bearing than `max_gap` median steps are not neighbours. Error for a cloud that is
/// not organized, or has a point that is not finite or at the laser itself; `name` says which cloud.
ScanGrid GridOf(const PointCloud& cloud_laser, double max_gap, const std::string& name);

}  // namespace ariadne::slam
