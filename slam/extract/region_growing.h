#pragma once

#include "slam/extract/fit_surface.h"
#include "slam/extract/surface_normals.h"
#include "slam/geometry/angles.h"

namespace ariadne::slam {

struct RegionGrowingOptions {
  double max_angle = 0.2;
  double max_deviation = 4.0;
  double grazing_angle = 0.07;
  double min_gap = 0.1;
  int min_points = 30;
  double min_area = 0.02;
  double direction_step = RadFromDeg(1.5);
  double outline_cell = 0.25;
  SurfaceNormalOptions normals;
  SliceNoise noise;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_angle", self.max_angle, Unit("rad"), Range{0.0, 1.6},
          "between a point's normal and that of the region, 11 deg: several sigmas of a normal");
    visit("max_deviation", self.max_deviation, Unit("sigma"), Range{0.1, 1000.0},
          "of a point from the plane of the region");
    visit("grazing_angle", self.grazing_angle, Unit("rad"), Range{0.001, 1.5},
          "neighbours are on one surface if the beams would meet it at no less, as for lines");
    visit("min_gap", self.min_gap, Unit("m"), Range{0.0, 10.0},
          "that is always allowed between neighbours");
    visit("min_points", self.min_points, Unit(""), Range{3, 1000000}, "of a surface");
    visit("min_area", self.min_area, Unit("m^2"), Range{0.0, 100.0}, "of a surface, as for lines");
    visit("direction_step", self.direction_step, Unit("rad"), Range{0.001, 0.5},
          "of the cells for a cloud without slices, 1.5 deg");
    visit("outline_cell", self.outline_cell, Unit("m"), Range{0.01, 10.0},
          "without slices an outline is made of squares of this size");
    visit("normals", self.normals, "of the neighbourhoods");
    visit("noise", self.noise, "of the points, for the plane and its covariance");
  }
};

/// The comparator of the paper's detector, after Rabbani, van den Heuvel and Vosselman (2006): from the
/// flattest neighbourhood on, a region takes in neighbours whose normal is like its own and that lie on its
/// plane, which is fit anew as it grows; then the flattest one that is left begins the next region. Points
/// at edges, whose normal says nothing, join by their distance alone, and do not lead on; so do points that
/// are too far from others for a normal, on surfaces that are met at a grazing angle, and these lead on.
/// No randomness.
///
/// Neighbours are those of the slices, or, for a cloud without, of the directions. Surfaces are in the
/// laser frame, in the order in which they began.
std::vector<PlanarSurface> GrowRegions(const PointCloud& cloud_laser, const RegionGrowingOptions& options);

}  // namespace ariadne::slam
