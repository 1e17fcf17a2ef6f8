#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "planning/polygon/labelled_polygon.h"
#include "slam/base/options.h"

namespace ariadne::planning {

/// A line of a slice, from where it was seen; in the map frame [m].
struct SightedLine {
  Eigen::Vector2d from_map = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_map = Eigen::Vector2d::Zero();
  Eigen::Vector2d scanner_map = Eigen::Vector2d::Zero();
};

struct SparseEdgeOptions {
  double max_spacing = 0.0;
  double beam_step = 1.0;
  double piece = 0.25;
  double within = 0.15;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_spacing", self.max_spacing, Unit("m"), Range{0.0, 100.0},
          "between the points that beams make on a wall, by distance and angle: one that no scan has seen "
          "so densely is to be looked at again, once all else is seen. 0: seen is seen, as in the paper");
    visit("beam_step", self.beam_step, Unit("deg"), Range{0.001, 90.0}, "between the scanner's beams");
    visit("piece", self.piece, Unit("m"), Range{0.01, 100.0}, "of an edge, that is dense or not");
    visit("within", self.within, Unit("m"), Range{0.0, 10.0},
          "from a line to the edges that it stands for: more than registration errs");
  }
};

/// The same area, with those pieces of its seen edges unseen that none of the lines shows densely enough;
/// what was unseen stays so. With max_spacing 0 nothing changes.
std::vector<LabelledPolygon> WithSparseUnseen(std::span<const LabelledPolygon> area,
                                              std::span<const SightedLine> lines,
                                              const SparseEdgeOptions& options);

}  // namespace ariadne::planning
