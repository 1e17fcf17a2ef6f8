#pragma once

#include <Eigen/Core>
#include <vector>

namespace ariadne::experiments {

/// An open tour that no 2-opt move (a part reversed) and no Or-opt move (up to three places elsewhere, also
/// reversed) makes shorter: the shortest of those that begin with each other place in turn and then go on
/// to the nearest one.
std::vector<std::size_t> ImprovedTour(const Eigen::MatrixXd& distances, std::size_t start);

double LengthOf(const Eigen::MatrixXd& distances, const std::vector<std::size_t>& order);

}  // namespace ariadne::experiments
