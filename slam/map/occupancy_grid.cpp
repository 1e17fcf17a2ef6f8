#include "slam/map/occupancy_grid.h"

#include "slam/base/error.h"
#include "slam/map/grid_votes.h"

namespace ariadne::slam {

Occupancy OccupancyGrid::At(std::size_t column, std::size_t row) const {
  const float odds = LogOdds(column, row);
  if (odds == 0.0F) return Occupancy::kUnknown;
  return odds > 0.0F ? Occupancy::kOccupied : Occupancy::kFree;
}

OccupancyGrid MakeOccupancyGrid(std::span<const PosedCloud> scans, const OccupancyGridOptions& options) {
  CheckOptions(options, "grid.");
  if (options.min_height > options.max_height) {
    Fail("grid.min_height is {} m, above grid.max_height, {} m", options.min_height, options.max_height);
  }
  CellBox box;
  for (const PosedCloud& scan : scans) box.extend(CellsOf(scan, options));
  GridVotes votes(box, options);
  for (const PosedCloud& scan : scans) votes.Meet(MetBy(scan, options));
  for (const PosedCloud& scan : scans) votes.Vote(MakeGridPart(scan, options));
  return std::move(votes).Finish();
}

}  // namespace ariadne::slam
