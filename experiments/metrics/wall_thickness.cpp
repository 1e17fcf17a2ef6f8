#include "experiments/metrics/wall_thickness.h"

#include <algorithm>

#include "experiments/metrics/statistics.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// The signed distances of the points of each face.
std::vector<std::vector<double>> DistancesByFace(const std::vector<Eigen::Vector3d>& points_world,
                                                 const std::vector<std::uint32_t>& face_of_point,
                                                 const WallFaces& walls) {
  std::vector<std::vector<double>> distances(walls.faces.size());
  for (std::size_t k = 0; k < points_world.size(); ++k) {
    const std::uint32_t face = face_of_point[k];
    if (face == kNoWall) continue;
    distances[face].push_back(walls.faces[face].plane_world.Distance(points_world[k]));
  }
  return distances;
}

WallThickness Measure(std::uint32_t face, std::vector<double> distances) {
  std::sort(distances.begin(), distances.end());
  return {face, distances.size(), Mean(distances), StandardDeviation(distances),
          QuantileOfSorted(distances, 0.95) - QuantileOfSorted(distances, 0.05)};
}

}  // namespace

WallThicknessSummary MeasureWallThickness(const std::vector<Eigen::Vector3d>& points_world,
                                          const std::vector<std::uint32_t>& face_of_point,
                                          const WallFaces& walls, const WallThicknessOptions& options) {
  if (points_world.size() != face_of_point.size())
    Fail("{} points are assigned to walls, not {}", face_of_point.size(), points_world.size());
  WallThicknessSummary summary;
  std::vector<double> deviations, spreads;
  std::vector<std::vector<double>> distances = DistancesByFace(points_world, face_of_point, walls);
  for (std::uint32_t face = 0; face < distances.size(); ++face) {
    if (distances[face].empty() || distances[face].size() < options.min_points) continue;
    summary.walls.push_back(Measure(face, std::move(distances[face])));
    deviations.push_back(summary.walls.back().standard_deviation);
    spreads.push_back(summary.walls.back().spread);
  }
  if (summary.walls.empty()) return summary;
  summary.median_standard_deviation = Median(deviations);
  summary.worst_standard_deviation = *std::max_element(deviations.begin(), deviations.end());
  summary.median_spread = Median(spreads);
  summary.worst_spread = *std::max_element(spreads.begin(), spreads.end());
  return summary;
}

}  // namespace ariadne::experiments
