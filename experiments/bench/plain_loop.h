#pragma once

#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::bench {

/// The yardstick: point-to-point ICP as one would write it on nanoflann in an afternoon. One tree, one
/// search per point and iteration, the SVD; two threads share the points. Same gate, same stop rule, same
/// result as Align().
struct PlainResult {
  slam::Pose3 T_model_data;
  int iterations = 0;
};

PlainResult PlainLoop(const std::vector<Eigen::Vector3d>& model, const std::vector<Eigen::Vector3d>& data,
                      const slam::Pose3& T_model_data_guess, double max_distance, double convergence_rms,
                      int threads);

}  // namespace ariadne::bench
