#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "slam/base/parallel.h"
#include "slam/geometry/pose3.h"
#include "slam/search/kd_tree.h"

namespace ariadne::slam {

/// Pairs per chunk of the loops over all pairs, and so the order in which their sums are taken.
inline constexpr std::size_t kPairsPerChunk = 512;

/// For each data point the closest model point (Sec. 3.1), or kNoPoint where none is closer than the gate.
struct Correspondences {
  std::vector<std::uint32_t> model_index;
  std::vector<double> squared_distance;  // [m^2]; meaningless where there is no pair
};

/// Compares every data point with every model point: O(n m), the reference for the other two.
Correspondences FindByBruteForce(const std::vector<Eigen::Vector3d>& model,
                                 const std::vector<Eigen::Vector3d>& data, const Pose3& T_model_data,
                                 double max_distance, const Parallel& parallel);

/// One search in the k-d tree per data point.
Correspondences FindByKdTree(const KdTree& model, const std::vector<Eigen::Vector3d>& data,
                             const Pose3& T_model_data, double max_distance, const Parallel& parallel);

}  // namespace ariadne::slam
