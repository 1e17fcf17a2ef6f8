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

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("closure", self.closure,
          "behind the scanner: through_scanner claims nothing that a 180 degree scan has not looked at, "
          "chord is the paper's single edge (4.2)");
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
