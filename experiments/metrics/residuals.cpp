#include "experiments/metrics/residuals.h"

#include <algorithm>
#include <cmath>

#include "slam/registration/correspondences.h"

namespace ariadne::experiments {

PairResidual MeasureResidual(const slam::KdTree& model_laser,
                             const std::vector<Eigen::Vector3d>& data_laser,
                             const slam::Pose3& T_model_data, double max_distance,
                             const Parallel& parallel) {
  const slam::Correspondences found =
      slam::FindByKdTree(model_laser, data_laser, T_model_data, max_distance, parallel);
  std::vector<double> squared;
  double sum = 0.0;
  for (std::size_t i = 0; i < found.model_index.size(); ++i) {
    if (found.model_index[i] == slam::kNoPoint) continue;
    squared.push_back(found.squared_distance[i]);
    sum += found.squared_distance[i];
  }
  if (squared.empty()) return {};
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return {squared.size(), std::sqrt(*middle), std::sqrt(sum / static_cast<double>(squared.size()))};
}

std::vector<ResidualChange> MeasureResiduals(const std::vector<slam::MapScan>& scans,
                                             const std::vector<slam::Pose3>& T_odom_laser,
                                             std::size_t min_pairs, double max_distance,
                                             const Parallel& parallel) {
  std::vector<ResidualChange> changes;
  for (std::size_t data = 1; data < scans.size(); ++data) {
    for (std::size_t model = 0; model < data; ++model) {
      const auto measure = [&](const slam::Pose3& T_map_model, const slam::Pose3& T_map_data) {
        return MeasureResidual(scans[model].tree_laser, scans[data].points_laser.positions,
                               T_map_model.Inverse() * T_map_data, max_distance, parallel);
      };
      const PairResidual after = measure(scans[model].T_map_laser, scans[data].T_map_laser);
      if (after.pairs <= min_pairs) continue;
      changes.push_back({model, data, measure(T_odom_laser[model], T_odom_laser[data]), after});
    }
  }
  return changes;
}

}  // namespace ariadne::experiments
