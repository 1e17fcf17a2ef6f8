#pragma once

#include <ceres/cost_function.h>

#include <memory>
#include <vector>

#include "slam/matching/map_scan.h"
#include "slam/registration/correspondence_tracker.h"
#include "slam/registration/pair_weight.h"

namespace ariadne::slam {

/// Two scans whose points are paired, as many scans are matched at once. Refers to both and to the options,
/// which it takes as Align() does in its last iterations: the gate is at max_distance, the kernel counts.
class JointPair {
 public:
  /// The scans have the surfaces that the metric needs.
  JointPair(const MapScan& model, const MapScan& data, const AlignOptions& options);

  /// How many points of the data have one of the model within the gate.
  std::size_t CountOverlap(const Pose3& T_model_data);

  /// Pairs the data's points with the model's at a relative pose, and weighs the pairs. Returns how many.
  std::size_t FindPairs(const Pose3& T_model_data);

  /// The energy of the pairs, as a factor of the poses of data and model in the map, in this order.
  std::unique_ptr<ceres::CostFunction> MakeFactor() const;

  std::size_t size() const { return pairs_.size(); }
  double sum_squared() const { return sum_squared_; }  // weighted, by the metric, where found [m^2]
  double weight() const { return weight_; }            // of all pairs together

 private:
  struct WeightedPair {
    std::uint32_t data = 0;
    std::uint32_t model = 0;
    double weight = 0.0;
  };

  void Weigh(const std::vector<double>& squared_residuals);

  const MapScan& model_;
  const MapScan& data_;
  const AlignOptions& options_;
  CorrespondenceTracker tracker_;
  Pose3 T_model_data_;  // where the pairs were found
  std::vector<WeightedPair> pairs_;
  double sum_squared_ = 0.0;
  double weight_ = 0.0;
};

}  // namespace ariadne::slam
