#pragma once

#include <Eigen/Geometry>
#include <cstddef>

namespace ariadne::slam {

/// Cells by their place in the map: counted from its origin, in units of the resolution. Both corners
/// belong to it.
using CellBox = Eigen::AlignedBox2i;

/// Error where there are more than 100 million; `resolution` [m] is for its sentence.
std::size_t CellCount(const CellBox& box, double resolution);

/// Of a cell in the box, row by row.
std::size_t IndexIn(const CellBox& box, const Eigen::Vector2i& cell);

}  // namespace ariadne::slam
