#pragma once

#include <cstddef>
#include <vector>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Finds the slices of a scan whose file does not tell them, from the order of its points: within a slice
/// the angle from the tilt axis (the laser's y) runs one way, and jumps back where the next slice begins.
/// Returns the first point of each slice, or nothing where the points are not in the order of a pitched
/// 2D scanner.
std::vector<std::size_t> InferSlices(const std::vector<Eigen::Vector3d>& positions_laser);

}  // namespace ariadne::slam
