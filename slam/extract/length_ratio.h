#pragma once

#include "slam/extract/fit_segment.h"

namespace ariadne::slam {

/// The paper's line detector (Sec. 2.2.1 step 2): a line grows along the ordered reduced points as long as
/// the chord to its first point is nearly as long as the path.
struct LengthRatioOptions {
  double join_distance = 0.05;
  double epsilon_three = 0.9;
  double epsilon_many = 0.99;
  double max_gap = 0.5;
  int min_points = 4;
  SliceNoise noise;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "join_distance", self.join_distance, Unit("m"), Range{0.0, 10.0},
        "neighbours this close are joined before; open in the paper. Noise lowers the ratio by the square "
        "of its share in the spacing, and joining keeps the spacing of near walls above it");
    visit("epsilon_three", self.epsilon_three, Unit(""), Range{0.0, 1.0},
          "the ratio that three points must exceed; open in the paper");
    visit("epsilon_many", self.epsilon_many, Unit(""), Range{0.0, 1.0},
          "the ratio that epsilon(j) rises to; open in the paper. Behind a corner the ratio falls as one "
          "point's share in the length, so it rises as 1/j");
    visit("max_gap", self.max_gap, Unit("m"), Range{1e-3, 1e3},
          "a line does not go on across more; open in the paper, 0.5 in the group's Hough line finder");
    visit("min_points", self.min_points, Unit(""), Range{2, 1000},
          "of a line, before they are joined; open in the paper, any three are a line at 0.9");
    visit("noise", self.noise, "of the points, for the fit and its covariance");
  }
};

/// epsilon(j) for a line of that many reduced points (3 or more).
double LengthRatioThreshold(int points, const LengthRatioOptions& options);

/// The lines of a slice whose points are in the order of the beams, along that order. Error where a point
/// is not finite or an option is out of its range.
std::vector<LineSegment> DetectByLengthRatio(std::span<const Eigen::Vector2d> points,
                                             const LengthRatioOptions& options);

}  // namespace ariadne::slam
