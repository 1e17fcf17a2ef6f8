#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Reads a velodyne scan of the KITTI benchmark (`.bin`): records of four 32-bit floats, little-endian,
/// x y z [m] and reflectance, in the axes of this project. Error with the byte where the file ends within a
/// record or a coordinate is NaN.
PointCloud ReadKitti(std::istream& in, const std::string& name);

/// Writes it; where the cloud has no reflectance, 0.
void WriteKitti(std::ostream& out, const PointCloud& cloud_laser);

}  // namespace ariadne::slam
