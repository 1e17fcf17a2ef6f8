#pragma once

#include <span>
#include <vector>

#include "slam/extract/detect_lines.h"
#include "slam/geometry/drawing.h"
#include "slam/map/horizontal_slice.h"
#include "slam/map/map_line.h"

namespace ariadne::slam {

/// The detectors for the points at a height: those come from many sweeps of the scanner, and Hough's has to
/// take them without an order, as the group's does (Sec. 4.2).
inline LineOptions LinesAtAHeight() {
  LineOptions lines;
  lines.hough.order = PointOrder::kUnordered;
  return lines;
}

struct LineMapOptions {
  HorizontalSliceOptions slice;
  LineOptions lines = LinesAtAHeight();
  double min_length = 0.1;
  MergeLinesOptions merge;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("slice", self.slice, "which points: those at a height");
    visit("lines", self.lines,
          "how the points of a scan become lines; hough is the paper's (4.2). The others get the points in "
          "the order of their bearings; split_and_merge makes fewer lines of clutter");
    visit("min_length", self.min_length, Unit("m"), Range{0.0, 100.0},
          "of a line before it is merged with others; shorter ones are what clutter and chance bring");
    visit("merge", self.merge, "which lines of several scans are one");
  }
};

/// The 2D point and line map (Sec. 6): the points of the scans at a height, and what lines they make.
struct LineMap {
  std::vector<HorizontalSlice> slices;  // one per scan
  std::vector<MapLine> lines;           // those with most points first
};

/// Lines are looked for in each scan, seen from the place of the laser, where points are as accurate as the
/// scanner; in the map frame those that coincide become one. Error for places that are not finite and for
/// options out of their range.
LineMap MakeLineMap(std::span<const PosedCloud> scans, const LineMapOptions& options = {});

/// The map as a plan: a layer "points_..." per scan that has some, and the layer "lines".
Drawing DrawingOf(const LineMap& map);

}  // namespace ariadne::slam
