#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Reads text lines "x y z [reflectance]" in metres and the axes of this project (x forward, y left, z up),
/// separated by blanks, tabs, commas or semicolons, with `#` comments. `name` stands in the messages.
PointCloud ReadXyz(std::istream& in, const std::string& name);

/// Writes one line per point, with all digits of the coordinates and the reflectance where there is one.
void WriteXyz(std::ostream& out, const PointCloud& cloud);

}  // namespace ariadne::slam
