#include "slam/map/grid_part.h"

#include <algorithm>
#include <cmath>

#include "slam/map/grid_beam.h"
#include "slam/map/horizontal_slice.h"

namespace ariadne::slam {
namespace {

constexpr int kLayers = 64;

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

GridPart MetBy(std::span<const GridBeam> beams, const OccupancyGridOptions& options) {
  GridPart part{BoxOf(beams, options.resolution), {}, {}};
  part.met.assign(CellCount(part.box, options.resolution), 0);
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

}  // namespace ariadne::slam
