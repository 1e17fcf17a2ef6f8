#pragma once

#include <vector>

#include "slam/base/options.h"
#include "slam/extract/direction_grid.h"

namespace ariadne::slam {

struct SurfaceNormalOptions {
  double radius = 0.15;
  double radius_angle = 0.08;
  int min_neighbors = 6;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("radius", self.radius, Unit("m"), Range{1e-3, 10.0},
          "of the neighbourhood, at least: 6 mm of noise turn its normal by a degree or two");
    visit("radius_angle", self.radius_angle, Unit("rad"), Range{0.0, 1.0},
          "of the neighbourhood by the distance of its point, where that is more: slices on the floor 1 m "
          "below are 0.21 m apart at 5 m");
    visit("min_neighbors", self.min_neighbors, Unit("points"), Range{3, 10000}, "for a normal");
  }
};

/// The surface around a point, from its neighbours.
struct SurfaceNormal {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // towards the scanner; zero where there is none
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();    // [m]
  double rms = 0.0;                                  // of the neighbours across the surface [m]
  double flatness = 1.0;                             // share of that variance in all: 0 is flat

  bool exists() const { return flatness < 1.0; }
};

/// One for each point. Where there are many neighbours, rows and columns are skipped.
std::vector<SurfaceNormal> SurfaceNormals(const PointCloud& cloud_laser, const DirectionGrid& grid,
                                          const SurfaceNormalOptions& options);

}  // namespace ariadne::slam
