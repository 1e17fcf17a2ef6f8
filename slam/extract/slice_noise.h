#pragma once

#include <Eigen/Core>

#include "slam/base/options.h"

namespace ariadne::slam {

/// How far the points of a slice are from where the beams met a surface.
struct SliceNoise {
  double range_sigma = 0.006;
  double bearing_sigma = 0.0005;
  double prior_points = 4.0;
  double systematic_sigma = 0.0087;
  double systematic_length = 1.5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("range_sigma", self.range_sigma, Unit("m"), Range{1e-6, 1.0},
          "of a range; the 5 mm of the LMS-200 together with the rounding to 1 cm (2.9 mm)");
    visit("bearing_sigma", self.bearing_sigma, Unit("rad"), Range{0.0, 0.1},
          "of a beam's direction; open, a quarter of the radius of the LMS-200's cone");
    visit("prior_points", self.prior_points, Unit(""), Range{0.0, 1e6},
          "how many points' worth of trust the two sigmas have beside the scatter that is seen; the "
          "scatter of three points alone says next to nothing");
    visit("systematic_sigma", self.systematic_sigma, Unit("m"), Range{0.0, 1.0},
          "of the part of a range's error that neighbours share, and no scatter shows; the LMS-200's "
          "15 mm as the end of a uniform distribution (spec 9.5)");
    visit("systematic_length", self.systematic_length, Unit("m"), Range{0.01, 1000.0},
          "of range, over which that part changes by about itself; open, calibrations of such devices find "
          "a few metres from crest to trough");
  }
};

/// Of range_sigma: a beam along a line or a plane has no infinite weight.
inline constexpr double kLeastSigma = 1e-3;

/// Sigma across a line with this unit normal, of a point that the scanner at the origin sees, without the
/// systematic part [m].
double SigmaAcross(const Eigen::Vector2d& normal, const Eigen::Vector2d& p, const SliceNoise& noise);

}  // namespace ariadne::slam
