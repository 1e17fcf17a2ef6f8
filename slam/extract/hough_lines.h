#pragma once

#include <array>

#include "slam/extract/fit_segment.h"

namespace ariadne::slam {

/// Whether the points of a slice follow each other as the beams do.
enum class PointOrder { kOrdered, kUnordered };

/// The group's Hough line finder (spec 4.2), for slices of the scanner, and for points that several slices
/// brought into one plane.
struct HoughOptions {
  PointOrder order = PointOrder::kOrdered;
  double max_distance = 15.0;
  double cells_per_meter = 75.0;
  double line_distance = 0.031;
  double max_gap = 0.5;
  double bin = 0.01;
  int max_empty_bins = 50;
  int max_passes = 80;
  int min_points = 4;
  SliceNoise noise;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("order", self.order, "how a line is cut into segments: along the beams, or along the line");
    visit("max_distance", self.max_distance, Unit("m"), Range{0.1, 1000.0},
          "points with a larger coordinate are left out; 7.5 in the group's, 15 is the paper's ray (4.2)");
    visit("cells_per_meter", self.cells_per_meter, Unit("1/m"), Range{0.1, 10000.0},
          "accumulator cells in angle and in distance, per metre of the diagonal around the points");
    visit("line_distance", self.line_distance, Unit("m"), Range{1e-4, 10.0},
          "of a line's points, along the steeper axis");
    visit("max_gap", self.max_gap, Unit("m"), Range{1e-3, 1e3}, "ordered: a segment ends at more");
    visit("bin", self.bin, Unit("m"), Range{1e-4, 10.0}, "unordered: gaps are counted in bins of a line");
    visit("max_empty_bins", self.max_empty_bins, Unit("bins"), Range{0, 100000},
          "unordered: a segment ends after more; 3 in the group's, where many slices fill the bins, while "
          "the beams of one slice are up to decimetres apart");
    visit("max_passes", self.max_passes, Unit(""), Range{1, 100000}, "lines that are looked at");
    visit("min_points", self.min_points, Unit(""), Range{2, 1000},
          "of a segment; the group's has no limit and keeps single points as lines of length 0, which have "
          "no direction: here they remain points that no line explains");
    visit("noise", self.noise, "of the points, for the fit and its covariance");
  }
};

/// The lines of a slice, those with most points first. The scanner is at the origin. Error where a point is
/// not finite, an option is out of its range, or the points need more cells than there may be.
std::vector<LineSegment> DetectByHough(std::span<const Eigen::Vector2d> points,
                                       const HoughOptions& options);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::PointOrder> {
  static constexpr std::array<std::string_view, 2> value{"ordered", "unordered"};
};

}  // namespace ariadne
