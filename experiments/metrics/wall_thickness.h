#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/metrics/wall_faces.h"

namespace ariadne::experiments {

/// How thick one true wall is in a map: the spread of the signed distances s_k = n . p_k - offset of the
/// points that belong to it. A wall that is shifted as a whole is thin; one that stands twice is thick.
struct WallThickness {
  std::uint32_t face = kNoWall;
  std::size_t points = 0;
  double shift = 0.0;               // mean of s_k: how far the wall is from its place, along its normal [m]
  double standard_deviation = 0.0;  // sqrt((1/n) sum (s_k - mean)^2) [m]
  double spread = 0.0;              // from the 5 % to the 95 % quantile of s_k [m]
};

/// Over all walls that have enough points. Noise of sigma along the normal alone gives a standard deviation
/// of sigma and a spread of 3.29 sigma.
struct WallThicknessSummary {
  std::vector<WallThickness> walls;  // by face
  double median_standard_deviation = 0.0;
  double worst_standard_deviation = 0.0;
  double median_spread = 0.0;
  double worst_spread = 0.0;
};

struct WallThicknessOptions {
  std::size_t min_points = 100;  // walls with fewer are not measured
};

/// `face_of_point` is from AssignToWalls. The points must lie in the world by their master scan
/// (PlaceByMaster); but as only spreads count, a map that is tilted as a whole shows thick walls where they
/// are long: that is meant.
WallThicknessSummary MeasureWallThickness(const std::vector<Eigen::Vector3d>& points_world,
                                          const std::vector<std::uint32_t>& face_of_point,
                                          const WallFaces& walls, const WallThicknessOptions& options);

}  // namespace ariadne::experiments
