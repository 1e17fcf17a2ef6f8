#pragma once

#include <span>
#include <vector>

#include "planning/polygon/slice_polygon.h"

namespace ariadne::planning {

/// What the scanner sees of a line: the part that no other line hides.
struct VisiblePiece {
  std::size_t line = 0;
  double right = 0.0, left = 0.0;  // bearings of its ends, right < left, in [-pi, pi] [rad]
  Eigen::Vector2d right_scan = Eigen::Vector2d::Zero();
  Eigen::Vector2d left_scan = Eigen::Vector2d::Zero();
};

/// The pieces in the order of their bearings, from -pi on; a line across the direction behind the scanner
/// begins and ends there. See SlicePolygon for the lines that are left out.
std::vector<VisiblePiece> VisiblePieces(std::span<const SliceLine> lines_scan);

}  // namespace ariadne::planning
