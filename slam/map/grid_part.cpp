#include "slam/map/grid_part.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "slam/base/error.h"
#include "slam/map/grid_beam.h"
#include "slam/map/horizontal_slice.h"

namespace ariadne::slam {
namespace {

constexpr double kMostCells = 1e8;
constexpr int kLayers = 32;

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

Eigen::Vector2i CellAt(const Eigen::Vector3d& p_map, double resolution) {
  return (p_map.head<2>() / resolution).array().floor().cast<int>();
}

CellBox BoxOf(std::span<const GridBeam> beams, double resolution) {
  Eigen::AlignedBox2d box_map;
  for (const GridBeam& beam : beams) {
    box_map.extend(beam.from.head<2>());
    box_map.extend(beam.to.head<2>());
  }
  if (box_map.isEmpty()) return {};
  // A cell more on each side: rounding cannot lead out of the box, and what is known has a frame.
  constexpr double kFar = 5e8;  // [cells]
  const Eigen::Array2d low = ((box_map.min().array() / resolution).floor() - 1.0).max(-kFar);
  const Eigen::Array2d high = ((box_map.max().array() / resolution).floor() + 1.0).min(kFar);
  return {low.cast<int>().matrix(), high.cast<int>().matrix()};
}

double CellCount(const CellBox& box) {
  return box.isEmpty() ? 0.0 : (box.sizes().cast<double>().array() + 1.0).prod();
}

/// Error for a box that would need too much memory.
std::size_t CheckedCellCount(const CellBox& box, double resolution) {
  const double count = CellCount(box);
  if (!(count <= kMostCells)) {
    const Eigen::Vector2i size = box.sizes() + Eigen::Vector2i::Ones();
    Fail("a grid of {} x {} cells of {} m is too large; use larger cells, or limit the range of the beams",
         size.x(), size.y(), resolution);
  }
  return static_cast<std::size_t>(count);
}

std::size_t IndexIn(const CellBox& box, const Eigen::Vector2i& cell) {
  const Eigen::Vector2i at = cell - box.min();
  return static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(box.sizes().x() + 1) +
         static_cast<std::size_t>(at.x());
}

/// From heights to layers.
class LayerScale {
 public:
  explicit LayerScale(const OccupancyGridOptions& options)
      : low_(options.min_height),
        per_metre_(kLayers / std::max(options.max_height - options.min_height, 1e-6)) {}

  /// All layers between two heights.
  Layers Between(double z1, double z2) const {
    return From(LayerAt(std::min(z1, z2))) & ~FromAbove(LayerAt(std::max(z1, z2)));
  }

 private:
  int LayerAt(double z) const {
    return std::clamp(static_cast<int>((z - low_) * per_metre_), 0, kLayers - 1);
  }
  static Layers From(int layer) { return ~Layers{0} << layer; }
  static Layers FromAbove(int layer) { return layer == kLayers - 1 ? Layers{0} : From(layer + 1); }

  double low_, per_metre_;
};

/// All layers from the lowest to the highest: what is above a thing's foot and below its top is of it.
Layers Filled(Layers layers) {
  if (layers == 0) return 0;
  return (~Layers{0} << std::countr_zero(layers)) & (~Layers{0} >> std::countl_zero(layers));
}

GridPart MetBy(std::span<const GridBeam> beams, const OccupancyGridOptions& options) {
  GridPart part{BoxOf(beams, options.resolution), {}, {}};
  part.met.assign(CheckedCellCount(part.box, options.resolution), 0);
  const LayerScale scale(options);
  const double margin = 0.5 * options.resolution;
  for (const GridBeam& beam : beams) {
    if (!beam.hits) continue;
    part.met[IndexIn(part.box, CellAt(beam.to, options.resolution))] |=
        scale.Between(beam.to.z() - margin, beam.to.z() + margin);
  }
  return part;
}

void PassThrough(std::span<const GridBeam> beams, const OccupancyGridOptions& options, GridPart& part) {
  part.passed.assign(part.met.size(), 0);
  const LayerScale scale(options);
  const Eigen::Vector2d first =
      part.box.isEmpty() ? Eigen::Vector2d::Zero().eval() : part.box.min().cast<double>().eval();
  const auto place = [&](const Eigen::Vector3d& p_map) -> Eigen::Vector2d {
    return p_map.head<2>() / options.resolution - first;
  };
  const auto columns = static_cast<std::size_t>(part.box.isEmpty() ? 0 : part.box.sizes().x() + 1);
  for (const GridBeam& beam : beams) {
    const double z = beam.from.z(), rise = beam.to.z() - z;
    ForEachCell(place(beam.from), place(beam.to), [&](const Cell& cell, double enter, double leave) {
      const std::size_t index =
          static_cast<std::size_t>(cell.y()) * columns + static_cast<std::size_t>(cell.x());
      part.passed[index] |= scale.Between(z + enter * rise, z + leave * rise);
    });
  }
}

}  // namespace

CellBox CellsOf(const PosedCloud& scan, const OccupancyGridOptions& options) {
  RequireFinite(scan);
  return BoxOf(BeamsOf(scan, options), options.resolution);
}

GridPart MetBy(const PosedCloud& scan, const OccupancyGridOptions& options) {
  return MetBy(BeamsOf(scan, options), options);
}

GridPart MakeGridPart(const PosedCloud& scan, const OccupancyGridOptions& options) {
  const std::vector<GridBeam> beams = BeamsOf(scan, options);
  GridPart part = MetBy(beams, options);
  PassThrough(beams, options, part);
  return part;
}

GridVotes::GridVotes(const CellBox& box, const OccupancyGridOptions& options)
    : box_(box), options_(options) {
  if (box.isEmpty())
    Fail("no beam of the scans is between the heights of the grid; look at the z of the map");
  met_.assign(CheckedCellCount(box_, options.resolution), 0);
  grid_ = {options.resolution, options.resolution * box_.min().cast<double>(),
           static_cast<std::size_t>(box_.sizes().x() + 1), static_cast<std::size_t>(box_.sizes().y() + 1),
           std::vector<float>(met_.size(), 0.0F)};
}

/// The index of the first cell of a part's row.
std::size_t GridVotes::RowAt(const CellBox& box, int row) const {
  return IndexIn(box_, box.min() + Eigen::Vector2i(0, row));
}

void GridVotes::Meet(const GridPart& part) {
  if (part.box.isEmpty()) return;
  auto met = part.met.begin();
  for (int row = 0; row <= part.box.sizes().y(); ++row) {
    auto to = met_.begin() + static_cast<std::ptrdiff_t>(RowAt(part.box, row));
    for (int column = 0; column <= part.box.sizes().x(); ++column) *to++ |= *met++;
  }
}

void GridVotes::Vote(const GridPart& part) {
  if (part.box.isEmpty()) return;
  std::size_t from = 0;
  for (int row = 0; row <= part.box.sizes().y(); ++row) {
    std::size_t to = RowAt(part.box, row);
    for (int column = 0; column <= part.box.sizes().x(); ++column, ++from, ++to) {
      const Layers known = met_[to] == 0 ? ~Layers{0} : Filled(met_[to]);
      const bool met = part.met[from] != 0;
      if (!met && (part.passed[from] & known) == 0) continue;
      const double vote = met ? options_.hit : -options_.miss;
      grid_.log_odds[to] = static_cast<float>(
          std::clamp(grid_.log_odds[to] + vote, -options_.most_against, options_.most_for));
    }
  }
}

OccupancyGrid GridVotes::Finish() && { return std::move(grid_); }

}  // namespace ariadne::slam
