#include "experiments/bounds/shortest_tour.h"

#include <cmath>

#include "experiments/bounds/exact_tour.h"
#include "experiments/bounds/improved_tour.h"
#include "experiments/bounds/one_tree_bound.h"

namespace ariadne::experiments {
namespace {

void RequireDistances(const Eigen::MatrixXd& distances, std::size_t start) {
  if (distances.rows() != distances.cols()) {
    Fail("distances of a tour are {} x {}, not square", distances.rows(), distances.cols());
  }
  if (start >= static_cast<std::size_t>(distances.rows())) {
    Fail("a tour of {} places cannot start at place {}", distances.rows(), start);
  }
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double there = distances(i, j);
      const double back = distances(j, i);
      if (!std::isfinite(there) || there < 0.0)
        Fail("places {} and {} of a tour are {} m apart", j, i, there);
      if (std::abs(there - back) <= 1e-9 * (1.0 + there)) continue;
      Fail("places {} and {} of a tour are {} m apart, but {} m on the way back", j, i, back, there);
    }
  }
}

}  // namespace

ShortestTourResult ShortestTour(const Eigen::MatrixXd& distances, std::size_t start,
                                const ShortestTourOptions& options) {
  CheckOptions(options, "tour.");
  RequireDistances(distances, start);
  ShortestTourResult result;
  if (distances.rows() <= options.exact_places || distances.rows() <= 2) {
    result.order = ExactTour(distances, start);
    result.length = result.lower_bound = LengthOf(distances, result.order);
    return result;
  }
  result.order = ImprovedTour(distances, start);
  result.length = LengthOf(distances, result.order);
  result.lower_bound = std::min(result.length, OneTreeBound(distances, start, result.length));
  return result;
}

}  // namespace ariadne::experiments
