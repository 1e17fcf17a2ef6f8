#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam/base/options.h"

namespace ariadne::experiments {

struct ShortestTourOptions {
  int exact_places = 12;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("exact_places", self.exact_places, Unit(""), Range{0, 18},
          "up to which the shortest tour is found for certain; 18 take 40 MB");
  }
};

/// A way through all places, from a given one.
struct ShortestTourResult {
  std::vector<std::size_t> order;  // of the places, beginning with the start; all of them, once
  double length = 0.0;             // [m]
  double lower_bound = 0.0;        // no such way is shorter [m]; where it was found exactly, its length
};

/// The open tour from `start` through all places whose distances from each other [m] are given: up to
/// exact_places the shortest (Held and Karp 1962), and beyond it the best of nearest neighbour tours, one
/// for each place to begin with, improved by 2-opt and Or-opt, with the 1-tree bound (Held and Karp 1970).
/// Error unless the distances are a symmetric matrix of finite numbers, none negative.
ShortestTourResult ShortestTour(const Eigen::MatrixXd& distances, std::size_t start,
                                const ShortestTourOptions& options = {});

}  // namespace ariadne::experiments
