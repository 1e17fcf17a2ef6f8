#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace ariadne::slam {

/// Heights between which a beam counts, as z of the map [m].
struct HeightBand {
  double low;
  double high;
};

/// A beam as seen from above, as far as it is between two heights.
struct GridBeam {
  Eigen::Vector2d from;  // [m]
  Eigen::Vector2d to;    // [m]
  bool hits = false;     // whether its end is where it met something
};

/// Cuts a beam to a band and a range (0: to none). Nothing where it is not in the band at all.
std::optional<GridBeam> ClipBeam(const Eigen::Vector3d& viewpoint_map, const Eigen::Vector3d& p_map,
                                 const HeightBand& band, double max_range);

using Cell = Eigen::Array2i;

/// Calls visit(cell) for each cell that a line goes through, in its order (after Amanatides and Woo, 1987).
/// Coordinates count cells.
template <typename Visit>
void ForEachCell(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Visit& visit) {
  Cell cell = from.array().floor().cast<int>();
  const Cell last = to.array().floor().cast<int>();
  const Eigen::Array2d way = (to - from).array();
  // The share of the way at which the next border is crossed, in x and in y. Which axis is done is counted
  // in cells, so that rounding cannot lead past the last one.
  Eigen::Array2d next, across;
  for (int axis = 0; axis < 2; ++axis) {
    const double border = cell[axis] + (way[axis] > 0.0 ? 1.0 : 0.0);
    across[axis] = 1.0 / std::abs(way[axis]);
    next[axis] = (border - from[axis]) / way[axis];
  }
  visit(cell);
  while ((cell != last).any()) {
    const bool x_is_done = cell.x() == last.x(), y_is_done = cell.y() == last.y();
    const int axis = y_is_done || (!x_is_done && next.x() <= next.y()) ? 0 : 1;
    cell[axis] += last[axis] > cell[axis] ? 1 : -1;
    next[axis] += across[axis];
    visit(cell);
  }
}

}  // namespace ariadne::slam
