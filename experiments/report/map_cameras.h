#pragma once

#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/colored_points.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

// From where pictures of maps are taken. `frame` are the scans that must be in the picture.

/// Everything below the upper 15 % of the height: one looks into the rooms.
HeightBand WithoutCeiling(const std::vector<slam::PosedCloud>& scans);

/// From above, to scale.
Camera TopCamera(const std::vector<slam::PosedCloud>& frame);

/// At an angle, in perspective; `width` in pixels.
Camera ObliqueCamera(const std::vector<slam::PosedCloud>& frame, int width = 1600);

}  // namespace ariadne::experiments
