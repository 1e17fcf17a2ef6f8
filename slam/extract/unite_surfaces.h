#pragma once

#include <vector>

#include "slam/base/options.h"
#include "slam/extract/planar_surface.h"

namespace ariadne::slam {

struct UniteOptions {
  double max_angle = 0.17;
  double max_deviation = 3.4;
  double angle_tolerance = 0.01;
  double distance_tolerance = 0.01;
  double max_gap = 0.25;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_angle", self.max_angle, Unit("rad"), Range{0.0, 1.5},
          "between the normals of two surfaces that may be one, 10 deg, however uncertain these are; open");
    visit("max_deviation", self.max_deviation, Unit("sigma"), Range{0.1, 1000.0},
          "between two planes that are one, of two turns and a shift together: 99 % of such pairs are "
          "nearer");
    visit("angle_tolerance", self.angle_tolerance, Unit("rad"), Range{0.0, 1.0},
          "sigma that each plane has beyond its covariance, 0.6 deg: no wall is flat, and no pose exact");
    visit("distance_tolerance", self.distance_tolerance, Unit("m"), Range{0.0, 10.0},
          "sigma of the same in distance; more than the errors of the poses where scans are united");
    visit("max_gap", self.max_gap, Unit("m"), Range{0.0, 100.0},
          "between outlines: beams of one slice and slices are up to that far apart, and pieces of a wall "
          "beside something that stands in front of it; 0: they must overlap");
  }
};

/// Makes one of surfaces that lie in one plane and overlap, or nearly so: of one scan, or of several in the
/// map frame. Two planes are one if they face the same side and differ by no more than their covariances
/// and the tolerances explain (Mahalanobis distance of the two turns and the shift, in the frame of the
/// larger surface). Both sides of a thin wall remain two. The larger ones go first.
///
/// The outlines are united by Vatti's algorithm; a gap remains, and the surface then has several. The plane
/// is the mean of the two, weighed by covariances and shares of the points such that its covariance is
/// honest whatever errors the two have in common (covariance intersection, Julier and Uhlmann, 1997).
std::vector<PlanarSurface> UniteSurfaces(std::vector<PlanarSurface> surfaces, const UniteOptions& options);

}  // namespace ariadne::slam
