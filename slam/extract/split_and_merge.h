#pragma once

#include "slam/extract/fit_segment.h"

namespace ariadne::slam {

/// Beside the paper's detectors: ordered points are split at gaps and where they leave the chord of their
/// ends (Douglas and Peucker), and neighbours on one line are merged, each by what the noise allows.
struct SplitAndMergeOptions {
  double grazing_angle = 0.1;
  double max_deviation = 5.0;
  int max_strays = 2;
  int min_points = 4;
  SliceNoise noise;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("grazing_angle", self.grazing_angle, Unit("rad"), Range{0.001, 1.5},
          "two points are on one surface if the beams would meet it at no less, 6 deg (after Borges and "
          "Aldon, "
          "2004): the gap that is allowed grows with the range and with the step of the beams");
    visit("max_deviation", self.max_deviation, Unit("sigma"), Range{0.1, 1000.0},
          "of a point from its line or chord; 5 leaves room for the noise of the chord's own ends and for "
          "the "
          "systematic part of the range errors, and 3 would cut walls in pieces");
    visit("max_strays", self.max_strays, Unit("points"), Range{0, 1000},
          "between two pieces that may still be merged: at an edge the beam meets two surfaces");
    visit("min_points", self.min_points, Unit(""), Range{2, 1000},
          "of a line; two are always one, and three often by chance");
    visit("noise", self.noise, "of the points: what is a deviation, and the weights of the fit");
  }
};

/// The lines of a slice whose points are in the order of the beams, along that order. The scanner is at the
/// origin. Error where a point is not finite or an option is out of its range.
std::vector<LineSegment> DetectBySplitAndMerge(std::span<const Eigen::Vector2d> points,
                                               const SplitAndMergeOptions& options);

}  // namespace ariadne::slam
