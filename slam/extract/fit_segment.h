#pragma once

#include <optional>
#include <span>

#include "slam/base/options.h"
#include "slam/extract/line_segment.h"

namespace ariadne::slam {

/// How far the points of a slice are from where the beams met a surface.
struct SliceNoise {
  double range_sigma = 0.006;
  double bearing_sigma = 0.0005;
  double prior_points = 4.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("range_sigma", self.range_sigma, Unit("m"), Range{1e-6, 1.0},
          "of a range; the 5 mm of the LMS-200 together with the rounding to 1 cm (2.9 mm)");
    visit("bearing_sigma", self.bearing_sigma, Unit("rad"), Range{0.0, 0.1},
          "of a beam's direction; open, a quarter of the radius of the LMS-200's cone");
    visit("prior_points", self.prior_points, Unit(""), Range{0.0, 1e6},
          "how many points' worth of trust the two sigmas have beside the scatter that is seen; the "
          "scatter of three points alone says next to nothing");
  }
};

/// Sigma across a line with this unit normal, of a point that the scanner at the origin sees [m].
double SigmaAcross(const Eigen::Vector2d& normal, const Eigen::Vector2d& p, const SliceNoise& noise);

/// The line of least squared distances through points[indices] (ascending indices), each distance weighed
/// by the noise: total least squares where the beams meet the line alike. The noise that the covariance
/// stands for is scaled by the scatter of the points. Nothing where they are not at least two places.
std::optional<LineSegment> FitSegment(std::span<const Eigen::Vector2d> points,
                                      std::span<const std::size_t> indices, const SliceNoise& noise);

/// The same for the points first, ..., last.
std::optional<LineSegment> FitSegment(std::span<const Eigen::Vector2d> points, std::size_t first,
                                      std::size_t last, const SliceNoise& noise);

}  // namespace ariadne::slam
