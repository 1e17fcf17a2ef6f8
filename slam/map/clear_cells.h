#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "slam/map/grid_part.h"

namespace ariadne::slam {

/// Which cells beams show to be clear, row by row: where they leave no gap of `gap` layers one above the
/// other that none of them went through, in the cell or in one of those up to `around` cells beside it. A
/// table from above and a shelf's board from ahead leave the gap behind them unclear, although beams go
/// through many a layer of it.
std::vector<bool> ClearCells(std::span<const Layers> passed, std::size_t columns, int around, int gap);

}  // namespace ariadne::slam
