#include "slam/map/occupancy_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "slam/base/error.h"
#include "slam/map/grid_beam.h"
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
    for (const GridBeam& beam : BeamsOf(scan, options)) box.extend(beam.from).extend(beam.to);
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

/// Which cells a scan votes for and against.
class Ballot {
 public:
  explicit Ballot(const OccupancyGrid& grid)
      : first_((grid.origin_map.array() / grid.resolution).round().matrix()),
        resolution_(grid.resolution),
        columns_(grid.columns),
        votes_(grid.log_odds.size(), Vote::kNone) {}

  void Collect(std::span<const GridBeam> beams) {
    for (const GridBeam& beam : beams) {
      if (beam.hits) Cast(CellOf(beam.to), Vote::kFor);
    }
    for (const GridBeam& beam : beams) {
      ForEachCell(InCells(beam.from), InCells(beam.to),
                  [&](const Cell& cell) { Cast(cell, Vote::kAgainst); });
    }
  }

  /// Adds the votes up and begins anew.
  void CountInto(OccupancyGrid& grid, const OccupancyGridOptions& options) {
    for (const std::size_t cell : voted_) {
      const double sum = grid.log_odds[cell] + (votes_[cell] == Vote::kFor ? options.hit : -options.miss);
      grid.log_odds[cell] =
          static_cast<float>(std::clamp(sum, -options.max_log_odds, options.max_log_odds));
      votes_[cell] = Vote::kNone;
    }
    voted_.clear();
  }

 private:
  enum class Vote : char { kNone, kFor, kAgainst };

  Eigen::Vector2d InCells(const Eigen::Vector2d& p_map) const { return p_map / resolution_ - first_; }
  Cell CellOf(const Eigen::Vector2d& p_map) const { return InCells(p_map).array().floor().cast<int>(); }

  void Cast(const Cell& cell, Vote vote) {
    const std::size_t index =
        static_cast<std::size_t>(cell.y()) * columns_ + static_cast<std::size_t>(cell.x());
    if (votes_[index] != Vote::kNone) return;
    votes_[index] = vote;
    voted_.push_back(index);
  }

  Eigen::Vector2d first_;  // of the grid's corner, in cells
  double resolution_;
  std::size_t columns_;
  std::vector<Vote> votes_;
  std::vector<std::size_t> voted_;
};

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
  Ballot ballot(grid);
  for (const PosedCloud& scan : scans) {
    ballot.Collect(BeamsOf(scan, options));
    ballot.CountInto(grid, options);
  }
  return grid;
}

}  // namespace ariadne::slam
