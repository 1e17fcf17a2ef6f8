#pragma once

#include <vector>

#include "experiments/exploration/floor.h"
#include "planning/polygon/labelled_polygon.h"
#include "planning/polygon/visible_pieces.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

struct FloorScannerOptions {
  double field_of_view = 180.0;
  double max_range = 15.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("field_of_view", self.field_of_view, Unit("deg"), Range{1.0, 360.0},
          "the paper's scanner has 180");
    visit("max_range", self.max_range, Unit("m"), Range{0.1, 1000.0}, "what is farther is not seen");
  }
};

/// What the scanner sees of a floor from one place.
struct FloorView {
  slam::Pose2 T_map_scan;
  std::vector<planning::VisiblePiece> pieces;  // of walls, in the scan's frame, by bearing
  planning::LabelledPolygon polygon;           // what is then known to be free, with seen walls
};

/// Exact visibility, without errors. Directions without a wall in range are free up to the range, if the
/// floor is enclosed: yards wider than that are not explored otherwise. Else they may be windows to
/// nowhere.
FloorView ViewFloor(const Floor& floor, const slam::Pose2& T_map_scan, const FloorScannerOptions& options);

/// Whether a place on a wall is among what was seen, to 1 mm.
bool IsSeen(const FloorView& view, const Eigen::Vector2d& p_map);

}  // namespace ariadne::experiments
