#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <optional>

namespace ariadne::slam {

/// Heights between which a beam counts, as z of the map [m].
struct HeightBand {
  double low;
  double high;
};

/// A beam as far as it is between two heights.
struct GridBeam {
  Eigen::Vector3d from;  // [m]
  Eigen::Vector3d to;    // [m]
  bool hits = false;     // whether its end is where it met something
};

/// Cuts a beam to a band and a range (0: to none). Nothing where it is not in the band at all.
std::optional<GridBeam> ClipBeam(const Eigen::Vector3d& viewpoint_map, const Eigen::Vector3d& p_map,
                                 const HeightBand& band, double max_range);

using Cell = Eigen::Array2i;

/// Calls visit(cell, enter, leave) for each cell that a line goes through, in its order, with the shares of
/// the way at which it does (after Amanatides and Woo, 1987). Coordinates count cells.
template <typename Visit>
void ForEachCell(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Visit& visit) {
  Cell cell = from.array().floor().cast<int>();
  const Cell last = to.array().floor().cast<int>();
  const Eigen::Array2d pace = (to - from).array().inverse();  // share of the way per cell
  // The share at which the next border is crossed, in x and in y; none, where that axis is done. That is
  // counted in cells, so that rounding cannot lead past the last one.
  const auto border = [&](int axis) {
    if (cell[axis] == last[axis]) return std::numeric_limits<double>::infinity();
    return (cell[axis] + (last[axis] > cell[axis] ? 1.0 : 0.0) - from[axis]) * pace[axis];
  };
  double enter = 0.0;
  while ((cell != last).any()) {
    const double in_x = border(0), in_y = border(1);
    const int axis = in_x <= in_y ? 0 : 1;
    const double leave = std::clamp(std::min(in_x, in_y), enter, 1.0);
    visit(cell, enter, leave);
    cell[axis] += last[axis] > cell[axis] ? 1 : -1;
    enter = leave;
  }
  visit(cell, enter, 1.0);
}

}  // namespace ariadne::slam
