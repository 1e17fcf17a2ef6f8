#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam/base/options.h"
#include "slam/extract/line_moments.h"

namespace ariadne::slam {

/// A straight piece of the plan of a map, which one scan or several saw from the same side.
struct MapLine {
  Eigen::Vector2d from_map = Eigen::Vector2d::Zero();  // right end, as seen from that side [m]
  Eigen::Vector2d to_map = Eigen::Vector2d::Zero();    // left end [m]
  LineMoments moments_map;                             // of its points, weighed by the scanner's noise
  std::size_t points = 0;                              // that it explains
  std::vector<std::size_t> scans;                      // that saw it, ascending

  double Length() const { return (to_map - from_map).norm(); }
  /// From right to left, unit length.
  Eigen::Vector2d Tangent() const { return (to_map - from_map).normalized(); }
  /// Away from the side from which it was seen, unit length.
  Eigen::Vector2d Normal() const;
  /// Distance of its points, weighed by the noise [m].
  double Rms() const;
};

/// When two lines are one.
struct MergeLinesOptions {
  double max_angle = 0.17;
  double max_distance = 0.05;
  double max_gap = 0.5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "max_angle", self.max_angle, Unit("rad"), Range{0.0, 1.5},
        "between two lines; 10 deg leaves the decision about short lines, whose direction is not certain, "
        "to max_distance");
    visit("max_distance", self.max_distance, Unit("m"), Range{1e-4, 10.0},
          "of both ends of the shorter from the line of the longer; what noise and errors of the poses "
          "leave between two views of a wall");
    visit("max_gap", self.max_gap, Unit("m"), Range{0.0, 1000.0},
          "along the line; doors are wider, and remain open");
  }
};

/// Whether two lines are one: seen from the same side (the faces of a thin wall are two), and near each
/// other as the options say.
bool Coincide(const MapLine& a, const MapLine& b, const MergeLinesOptions& options);

/// The line of all points of both, along all that either covers.
MapLine Merged(const MapLine& a, const MapLine& b);

/// Lines of which no two coincide, those with most points first: each line, those with most points first,
/// is merged with the first that it coincides with, as often as that changes anything.
std::vector<MapLine> MergeLines(std::vector<MapLine> lines, const MergeLinesOptions& options);

}  // namespace ariadne::slam
