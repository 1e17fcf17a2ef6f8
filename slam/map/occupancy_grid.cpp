#include "slam/map/occupancy_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "slam/base/error.h"
#include "slam/map/grid_beam.h"
#include "slam/map/grid_votes.h"
#include "slam/map/horizontal_slice.h"

namespace ariadne::slam {
namespace {

using Box2 = Eigen::AlignedBox2d;

constexpr double kMostCells = 1e8;

/// The beams of a scan as far as they are between the heights.
std::vector<GridBeam> BeamsOf(const PosedCloud& scan, const OccupancyGridOptions& options) {
  const HeightBand band{options.min_height, options.max_height};
  std::vector<GridBeam> beams;
  for (const Eigen::Vector3d& p_laser : scan.cloud_laser.positions) {
    const auto beam =
        ClipBeam(scan.T_map_laser.translation, scan.T_map_laser * p_laser, band, options.max_range);
    if (beam) beams.push_back(*beam);
  }
  return beams;
}

Box2 BoxAround(std::span<const PosedCloud> scans, const OccupancyGridOptions& options) {
  Box2 box;
  for (const PosedCloud& scan : scans) {
    for (const GridBeam& beam : BeamsOf(scan, options)) {
      box.extend(beam.from.head<2>());
      box.extend(beam.to.head<2>());
    }
  }
  return box;
}

OccupancyGrid EmptyGrid(const Box2& box, double resolution) {
  if (box.isEmpty())
    Fail("no beam of the scans is between the heights of the grid; look at the z of the map");
  // A cell more on each side: rounding cannot lead out of the grid, and what is known has a frame.
  const Eigen::Array2d first = (box.min().array() / resolution).floor() - 1.0;
  const Eigen::Array2d count = (box.max().array() / resolution).floor() - first + 2.0;
  if (!(count.prod() <= kMostCells)) {
    Fail("a grid of {} x {} cells of {} m is too large; use larger cells, or limit the range of the beams",
         count.x(), count.y(), resolution);
  }
  OccupancyGrid grid{resolution,
                     (resolution * first).matrix(),
                     static_cast<std::size_t>(count.x()),
                     static_cast<std::size_t>(count.y()),
                     {}};
  grid.log_odds.assign(grid.columns * grid.rows, 0.0F);
  return grid;
}

/// From places to cells.
class Cells {
 public:
  explicit Cells(const OccupancyGrid& grid)
      : first_((grid.origin_map.array() / grid.resolution).round().matrix()),
        resolution_(grid.resolution),
        columns_(grid.columns) {}

  /// In units of cells, from the grid's corner.
  Eigen::Vector2d Place(const Eigen::Vector3d& p_map) const {
    return p_map.head<2>() / resolution_ - first_;
  }
  std::size_t IndexOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y()) * columns_ + static_cast<std::size_t>(cell.x());
  }
  std::size_t IndexAt(const Eigen::Vector3d& p_map) const {
    return IndexOf(Place(p_map).array().floor().cast<int>());
  }

 private:
  Eigen::Vector2d first_;
  double resolution_;
  std::size_t columns_;
};

void Collect(std::span<const GridBeam> beams, const Cells& cells, const SeenHeights& seen, Ballot& ballot) {
  for (const GridBeam& beam : beams) {
    if (beam.hits) ballot.Cast(cells.IndexAt(beam.to), Vote::kFor);
  }
  for (const GridBeam& beam : beams) {
    const double rise = beam.to.z() - beam.from.z();
    const auto visit = [&](const Cell& cell, double enter, double leave) {
      const std::size_t index = cells.IndexOf(cell);
      if (ballot.HasVoted(index)) return;
      const double z = beam.from.z();
      if (seen.WouldMeet(index, z + enter * rise, z + leave * rise)) ballot.Cast(index, Vote::kAgainst);
    };
    ForEachCell(cells.Place(beam.from), cells.Place(beam.to), visit);
  }
}

SeenHeights HeightsOf(std::span<const PosedCloud> scans, const Cells& cells, const OccupancyGrid& grid,
                      const OccupancyGridOptions& options) {
  SeenHeights seen(grid.log_odds.size(), 0.5 * grid.resolution);
  for (const PosedCloud& scan : scans) {
    for (const GridBeam& beam : BeamsOf(scan, options)) {
      if (beam.hits) seen.Add(cells.IndexAt(beam.to), beam.to.z());
    }
  }
  return seen;
}

}  // namespace

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
  for (const PosedCloud& scan : scans) RequireFinite(scan);
  OccupancyGrid grid = EmptyGrid(BoxAround(scans, options), options.resolution);
  const Cells cells(grid);
  const SeenHeights seen = HeightsOf(scans, cells, grid, options);
  const VoteOdds odds{options.hit, options.miss, options.max_log_odds};
  Ballot ballot(grid.log_odds.size());
  for (const PosedCloud& scan : scans) {
    Collect(BeamsOf(scan, options), cells, seen, ballot);
    ballot.CountInto(grid.log_odds, odds);
  }
  return grid;
}

}  // namespace ariadne::slam
