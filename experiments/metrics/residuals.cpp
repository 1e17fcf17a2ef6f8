#include "experiments/metrics/residuals.h"

#include <algorithm>
#include <cmath>

#include "experiments/metrics/statistics.h"
#include "slam/registration/correspondences.h"

namespace ariadne::experiments {
PairResidual MeasureResidual(const slam::MapScan& model, const slam::MapScan& data,
                             const slam::Pose3& T_model_data, double max_distance,
                             const Parallel& parallel) {
  const std::vector<Eigen::Vector3d>& points = data.points_laser.positions;
  const slam::Correspondences found =
      slam::FindByKdTree(model.tree_laser, points, T_model_data, max_distance, parallel);
  std::vector<double> distances, plane_distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t m = found.model_index[i];
    if (m == slam::kNoPoint) continue;
    distances.push_back(std::sqrt(found.squared_distance[i]));
    const slam::SurfacePoint& surface = model.surfaces_laser[m];
    if (!surface.has_normal()) continue;
    plane_distances.push_back(
        std::abs(surface.normal.dot(T_model_data * points[i] - model.tree_laser.points()[m])));
  }
  const Summary to_planes = Summarize(plane_distances);
  return {distances.size(), Summarize(distances).median, to_planes.median, to_planes.rms};
}

std::vector<ResidualChange> MeasureResiduals(const std::vector<slam::MapScan>& scans,
                                             const std::vector<slam::Pose3>& T_odom_laser,
                                             const ResidualOptions& options, const Parallel& parallel) {
  std::vector<ResidualChange> changes;
  for (std::size_t data = 1; data < scans.size(); ++data) {
    for (std::size_t model = 0; model < data; ++model) {
      const auto measure = [&](const slam::Pose3& T_map_model, const slam::Pose3& T_map_data) {
        return MeasureResidual(scans[model], scans[data], T_map_model.Inverse() * T_map_data,
                               options.max_distance, parallel);
      };
      const PairResidual after = measure(scans[model].T_map_laser, scans[data].T_map_laser);
      if (after.pairs <= options.min_pairs) continue;
      changes.push_back({model, data, measure(T_odom_laser[model], T_odom_laser[data]), after});
    }
  }
  return changes;
}

}  // namespace ariadne::experiments
