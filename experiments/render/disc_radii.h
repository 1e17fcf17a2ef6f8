#pragma once

#include <Eigen/Core>
#include <vector>

namespace ariadne::experiments {

/// For each point the radius [m] of a disc such that the discs of a surface close it: from the number of
/// points nearby. A point that is nearly alone is not part of a surface and gets a small one.
std::vector<float> DiscRadii(const std::vector<Eigen::Vector3d>& positions);

}  // namespace ariadne::experiments
