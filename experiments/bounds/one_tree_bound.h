#pragma once

#include <Eigen/Core>

namespace ariadne::experiments {

/// A length below which no open tour from `start` comes: of the shortest spanning tree, with a price on
/// each place that pulls its degree towards that in a tour (Held and Karp 1970). `length`: of a known tour
/// [m].
double OneTreeBound(const Eigen::MatrixXd& distances, std::size_t start, double length);

}  // namespace ariadne::experiments
