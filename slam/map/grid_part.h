#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "slam/map/occupancy_grid.h"

namespace ariadne::slam {

/// Cells by their place in the map: counted from its origin, in units of the resolution.
using CellBox = Eigen::AlignedBox2i;

/// Which of 32 layers between the heights of a grid, the lowest first.
using Layers = std::uint32_t;

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

/// Puts parts together: first all that they have met, then their votes, in the order of the scans.
class GridVotes {
 public:
  /// Error where the box is empty, or has more than 100 million cells.
  GridVotes(const CellBox& box, const OccupancyGridOptions& options);

  void Meet(const GridPart& part);
  void Vote(const GridPart& part);
  OccupancyGrid Finish() &&;

 private:
  std::size_t RowAt(const CellBox& box, int row) const;

  CellBox box_;
  OccupancyGridOptions options_;
  std::vector<Layers> met_;
  OccupancyGrid grid_;
};

}  // namespace ariadne::slam
