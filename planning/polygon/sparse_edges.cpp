#include "planning/polygon/sparse_edges.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector2d;

double DistanceToLine(const Vector2d& p_map, const SightedLine& line) {
  const Vector2d along = line.to_map - line.from_map;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((p_map - line.from_map).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p_map - line.from_map - share * along).norm();
}

/// Between the points that a scanner's beams make at a place of a wall [m].
double SpacingAt(const Vector2d& p_map, const Vector2d& wall_direction, const Vector2d& scanner_map,
                 double beam_step) {
  const Vector2d ray = p_map - scanner_map;
  const double across = std::abs(ray.x() * wall_direction.y() - ray.y() * wall_direction.x());
  return ray.squaredNorm() * beam_step / std::max(across, 1e-9);  // range times step over the sine
}

bool IsLeftOf(const Vector2d& p_map, const Vector2d& from_map, const Vector2d& direction) {
  const Vector2d to = p_map - from_map;
  return direction.x() * to.y() - direction.y() * to.x() > 0.0;
}

/// Whether lines show a piece of an edge densely enough, from the side where it is free: those of a thin
/// wall's other side are near it too.
class Density {
 public:
  Density(std::span<const SightedLine> lines, const SparseEdgeOptions& options)
      : lines_(lines), options_(options), beam_step_(slam::RadFromDeg(options.beam_step)) {}

  bool Suffices(const Vector2d& middle_map, const Vector2d& direction) const {
    return std::ranges::any_of(lines_, [&](const SightedLine& line) {
      return IsLeftOf(line.scanner_map, middle_map, direction) &&
             SpacingAt(middle_map, direction, line.scanner_map, beam_step_) <= options_.max_spacing &&
             DistanceToLine(middle_map, line) <= options_.within;
    });
  }

 private:
  std::span<const SightedLine> lines_;
  const SparseEdgeOptions& options_;
  double beam_step_;  // [rad]
};

LabelledRing WithSparseUnseen(const LabelledRing& ring, const Density& density, double piece) {
  LabelledRing relabelled;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d &from = ring[i].p_map, along = ring[(i + 1) % ring.size()].p_map - from;
    const double length = along.norm();
    const int pieces = ring[i].seen ? std::max(1, static_cast<int>(std::ceil(length / piece))) : 1;
    for (int k = 0; k < pieces; ++k) {
      const bool seen =
          ring[i].seen &&
          (length == 0.0 || density.Suffices(from + along * (k + 0.5) / pieces, along / length));
      if (k == 0 || seen != relabelled.back().seen)
        relabelled.push_back({from + along * static_cast<double>(k) / pieces, seen});
    }
  }
  return relabelled;
}

}  // namespace

std::vector<LabelledPolygon> WithSparseUnseen(std::span<const LabelledPolygon> area,
                                              std::span<const SightedLine> lines,
                                              const SparseEdgeOptions& options) {
  CheckOptions(options, "sparse.");
  if (options.max_spacing == 0.0) return {area.begin(), area.end()};
  const Density density(lines, options);
  std::vector<LabelledPolygon> relabelled;
  for (const LabelledPolygon& polygon : area) {
    LabelledPolygon same{WithSparseUnseen(polygon.outer, density, options.piece), {}};
    for (const LabelledRing& hole : polygon.holes)
      same.holes.push_back(WithSparseUnseen(hole, density, options.piece));
    relabelled.push_back(std::move(same));
  }
  return relabelled;
}

}  // namespace ariadne::planning
