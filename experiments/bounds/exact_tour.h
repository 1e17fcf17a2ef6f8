#pragma once

#include <Eigen/Core>
#include <vector>

namespace ariadne::experiments {

/// The shortest open tour, by dynamic programming over subsets (Held and Karp 1962): n^2 2^n steps. Of
/// equally short ones always the same.
std::vector<std::size_t> ExactTour(const Eigen::MatrixXd& distances, std::size_t start);

}  // namespace ariadne::experiments
