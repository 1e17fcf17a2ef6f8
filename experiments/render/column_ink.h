#pragma once

#include <vector>

#include "experiments/render/camera.h"

namespace ariadne::experiments {

/// How much ink each point drops so that a column of the building (a square of `column` [m] in the picture,
/// seen along the view) gets as much ink as it has layers with points in them, shared by its points. In a
/// top view a wall then gets the ink of its height and a floor that of one layer, however densely the
/// scanner hit them. Points outside of the picture get none. The camera is orthographic.
std::vector<float> ColumnInk(const std::vector<ImagePoint>& points, const Camera& camera, double column);

}  // namespace ariadne::experiments
