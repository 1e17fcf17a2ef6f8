#pragma once

#include <cstddef>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// What a file of points holds.
struct CloudFile {
  PointCloud cloud;
  std::size_t dropped = 0;  // points that the file marks as directions without a measurement
};

}  // namespace ariadne::slam
