#pragma once

#include <vector>

namespace ariadne::planning {

/// The squared distance [cells^2] from each cell of a raster, row after row, to the nearest of the cells
/// that are marked; infinity where none is. Exact below 2^24; time grows with the number of cells
/// (Felzenszwalb, Huttenlocher: Distance Transforms of Sampled Functions, 2012).
std::vector<float> SquaredDistances(const std::vector<bool>& marked, int columns, int rows);

}  // namespace ariadne::planning
