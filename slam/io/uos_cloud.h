#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Reads a uos scan (`.3d`): lines "x y z [reflectance]" in centimetres and left-handed axes (uos_axes.h),
/// converted to metres and the axes of this project. A first line "226 x 360" says rows x columns; where
/// that is the number of points, the rows are the slices.
PointCloud ReadUosCloud(std::istream& in, const std::string& name);

/// Writes it with 12 digits, and with the first line where all slices have the same number of points.
void WriteUosCloud(std::ostream& out, const PointCloud& cloud_laser);

}  // namespace ariadne::slam
