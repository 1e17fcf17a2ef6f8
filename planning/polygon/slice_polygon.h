#pragma once

#include <array>
#include <span>

#include "planning/polygon/labelled_polygon.h"
#include "slam/base/options.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

/// A line of a slice as seen by the scanner: it stands at the origin, x to where it looks [m].
struct SliceLine {
  Eigen::Vector2d from_scan = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_scan = Eigen::Vector2d::Zero();
};

/// How the polygon is closed behind the scanner.
enum class PolygonClosure {
  kThroughScanner,  // by two edges that meet at the scanner's place: right for a scan of 180 degrees
  kChord,           // by one edge, as between any other two lines: 2 n edges for n lines (the paper's)
};

struct SlicePolygonOptions {
  PolygonClosure closure = PolygonClosure::kThroughScanner;
  double free_range = 0.0;
  double field_of_view = 180.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("closure", self.closure,
          "behind the scanner: through_scanner claims nothing that a 180 degree scan has not looked at, "
          "chord is the paper's single edge (4.2)");
    visit("free_range", self.free_range, Unit("m"), Range{0.0, 1000.0},
          "up to where a direction in which no line was found is free: the scanner's range, if all that "
          "stands within it sends light back. Halls wider than that cannot be explored otherwise. The "
          "paper has none (0): an edge joins the lines on both sides");
    visit("field_of_view", self.field_of_view, Unit("deg"), Range{1.0, 360.0},
          "of the scanner, for free_range: nothing was looked for outside of it");
  }
};

/// Lines become seen edges, sorted by their bearing from the scanner, and an unseen edge joins the left end
/// of each to the right end of the next (Sec. 4.2 step 3: the smallest angle between line ends as seen from
/// the scanner). The lines may lie in any order, and each may run either way.
///
/// The result is simple and star-shaped about the scanner, whatever the lines. Where lines hide or cross
/// each other (noise; points of different scan rows), the nearest counts and the others are cut: a line is
/// then several edges, or none. A jump from one line to another is an unseen edge along the ray. A gap of
/// 180 degrees or more is closed through the scanner's place, since a chord would leave the scanner
/// outside. Left out are lines that say nothing of free space: those seen end on (under 0.1 mrad) and those
/// that pass the scanner within 1 cm. No line left: an empty polygon.
///
/// With a free_range, gaps of more than 4 mrad reach out to it, by unseen chords of at most 5 degrees; then
/// no line is no empty polygon either.
///
/// Error where a line or the pose is NaN or infinite.
LabelledPolygon SlicePolygon(std::span<const SliceLine> lines_scan, const slam::Pose2& T_map_scan,
                             const SlicePolygonOptions& options = {});

}  // namespace ariadne::planning

namespace ariadne {

template <>
struct EnumNames<planning::PolygonClosure> {
  static constexpr std::array<std::string_view, 2> value{"through_scanner", "chord"};
};

}  // namespace ariadne
