#pragma once

#include <cstdint>
#include <vector>

#include "slam/map/cell_box.h"
#include "slam/map/occupancy_grid.h"

namespace ariadne::slam {

/// Which of 64 layers between the heights of a grid, the lowest first.
using Layers = std::uint64_t;

/// What one scan says of the cells around it, whatever others say.
struct GridPart {
  CellBox box;                 // around all its beams, and a cell more; empty where none is at the heights
  std::vector<Layers> met;     // by cell, row by row: where it has points
  std::vector<Layers> passed;  // where its beams go through
};

/// Around the cells that the beams of a scan go through or end in, and a cell more. Error for what is not
/// finite.
CellBox CellsOf(const PosedCloud& scan, const OccupancyGridOptions& options);

/// Where the scan has points; nothing is said of where its beams went through.
GridPart MetBy(const PosedCloud& scan, const OccupancyGridOptions& options);

/// All that a scan says. It depends on its pose only by where its beams are.
GridPart MakeGridPart(const PosedCloud& scan, const OccupancyGridOptions& options);

}  // namespace ariadne::slam
