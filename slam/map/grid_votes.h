#pragma once

#include <vector>

#include "slam/map/grid_part.h"

namespace ariadne::slam {

/// Puts parts together: first all that they have met, then their votes, in the order of the scans.
class GridVotes {
 public:
  /// Error where the box is empty, or has more than 100 million cells.
  GridVotes(const CellBox& box, const OccupancyGridOptions& options);

  void Meet(const GridPart& part);
  void Vote(const GridPart& part);
  OccupancyGrid Finish() &&;

  /// The layers that beams of any part went through, cell by cell.
  const std::vector<Layers>& passed() const { return passed_; }

 private:
  /// A cell that is taken for occupied, and at which heights a beam would show that it is not.
  struct Thing {
    std::size_t cell;
    Layers layers;
  };

  std::size_t RowAt(const CellBox& box, int row) const;
  bool IsPassed(std::size_t cell, Layers layers) const;
  std::vector<std::size_t> Around(std::size_t cell) const;
  std::vector<Thing> Grown(const std::vector<Thing>& things);

  CellBox box_;
  OccupancyGridOptions options_;
  std::vector<Layers> met_;
  std::vector<Layers> passed_;
  OccupancyGrid grid_;
};

}  // namespace ariadne::slam
