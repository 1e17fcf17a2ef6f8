#pragma once

#include "planning/polygon/slice_polygon.h"
#include "slam/extract/detect_lines.h"
#include "slam/map/horizontal_slice.h"

namespace ariadne::planning {

/// Hough's lines, of points without an order, as the paper has it (Sec. 4.2 step 2).
inline slam::LineOptions LinesForPolygons() {
  slam::LineOptions lines;
  lines.method = slam::LineMethod::kHough;
  lines.hough.order = slam::PointOrder::kUnordered;
  return lines;
}

struct ScanPolygonOptions {
  slam::HorizontalSliceOptions slice;
  bool between_rows = true;
  double row_jump = 0.1;
  slam::LineOptions lines = LinesForPolygons();
  double min_length = 0.0;
  bool keep_points = true;
  double see_through_gap = 0.1;
  double see_through_depth = 0.1;
  SlicePolygonOptions polygon;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("slice", self.slice, "which points: those at a height");
    visit(
        "between_rows", self.between_rows,
        "rows of a scan that are further apart than the slice is thick leave gaps: where two of them pass "
        "its height, a point between them counts too");
    visit("row_jump", self.row_jump, Unit("m"), Range{0.0, 10.0},
          "by how much their ranges may differ on one surface; above what a pitch step of 1 deg makes of "
          "a wall, below the depth of furniture");
    visit("lines", self.lines, "how they become lines; hough without an order is the paper's (4.2)");
    visit("min_length", self.min_length, Unit("m"), Range{0.0, 100.0},
          "of a line; 0 keeps all lengths, as the paper does");
    visit("keep_points", self.keep_points,
          "points that no line explains are corners of the polygon: the paper's lines of length 0 (4.2)");
    visit(
        "see_through_gap", self.see_through_gap, Unit("m"), Range{0.0, 100.0},
        "between neighbouring points of a line, from where on it is cut if the scanner saw through; below "
        "a door, above the spacing of the beams on most walls");
    visit("see_through_depth", self.see_through_depth, Unit("m"), Range{0.0, 100.0},
          "how far behind the line a point between its neighbours proves that; above the noise");
    visit("polygon", self.polygon, "how the lines are joined");
  }
};

/// The lines of a scan at a height, as the scanner sees them: x to where it looks. A detector that takes
/// points without an order also joins what lies in line by chance; such a line is cut between two of its
/// points where the scanner saw something behind it.
///
/// Error where a coordinate or the pose is NaN or infinite, or an option is out of its range.
std::vector<SliceLine> LinesOfScan(const slam::PosedCloud& scan, const ScanPolygonOptions& options = {});

/// What a registered scan shows to be free at a height (Sec. 4.2 steps 1 to 3). Errors as LinesOfScan.
LabelledPolygon ScanPolygon(const slam::PosedCloud& scan, const ScanPolygonOptions& options = {});

}  // namespace ariadne::planning
