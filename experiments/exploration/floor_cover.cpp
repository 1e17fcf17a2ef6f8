#include "experiments/exploration/floor_cover.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kFarthestStart = 1.0;  // what the docstring promises [m]

double DistanceTo(const FloorWall& face, const Eigen::Vector2d& p) {
  const Eigen::Vector2d d = face.to - face.from;
  const double share = std::clamp((p - face.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p - face.from - share * d).norm();
}

/// Which cells of a grid around the floor are free.
struct FreeCells {
  Eigen::Vector2d low;
  double step = 0.0;
  int width = 0, height = 0;
  std::vector<std::uint8_t> free;

  Eigen::Vector2d Place(int x, int y) const { return low + step * Eigen::Vector2d(x, y); }
  std::uint8_t& At(int x, int y) {
    return free[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  }
};

FreeCells CellsAround(const Floor& floor, const FloorCoverOptions& options) {
  Eigen::AlignedBox2d box;
  for (const FloorWall& face : floor.faces) box.extend(face.from).extend(face.to);
  FreeCells cells{box.min(), options.resolution, 0, 0, {}};
  cells.width = static_cast<int>(box.sizes().x() / cells.step) + 1;
  cells.height = static_cast<int>(box.sizes().y() / cells.step) + 1;
  cells.free.assign(static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.height), 1);
  return cells;
}

void Block(const FloorWall& face, double radius, FreeCells& cells) {
  const auto cell = [&](double v) { return static_cast<int>(std::floor(v / cells.step)); };
  const Eigen::Vector2d low = face.from.cwiseMin(face.to).array() - radius;
  const Eigen::Vector2d high = face.from.cwiseMax(face.to).array() + radius;
  const Eigen::Vector2d first = low - cells.low, last = high - cells.low;
  for (int y = std::max(0, cell(first.y())); y <= std::min(cells.height - 1, cell(last.y()) + 1); ++y) {
    for (int x = std::max(0, cell(first.x())); x <= std::min(cells.width - 1, cell(last.x()) + 1); ++x) {
      if (DistanceTo(face, cells.Place(x, y)) < radius) cells.At(x, y) = 0;
    }
  }
}

std::pair<int, int> StartCell(const Floor& floor, FreeCells& cells) {
  std::pair<int, int> nearest{0, 0};
  double distance = kFarthestStart;
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      const double d = (cells.Place(x, y) - floor.T_map_start.translation).norm();
      if (cells.At(x, y) == 0 || d >= distance) continue;
      distance = d;
      nearest = {x, y};
    }
  }
  if (distance == kFarthestStart) Fail("{}: the robot does not fit in where it starts", floor.name);
  return nearest;
}

FloorCover SampleWalls(const Floor& floor, double spacing) {
  FloorCover samples{{}, spacing};
  double left_over = 0.5 * spacing;  // carried from face to face, so that each sample stands for as much
  for (const FloorWall& face : floor.faces) {
    if (!face.upright) continue;
    const double length = (face.to - face.from).norm();
    for (; left_over < length; left_over += spacing) {
      samples.places_map.push_back(face.from + left_over / length * (face.to - face.from));
    }
    left_over -= length;
  }
  return samples;
}

}  // namespace

std::vector<Eigen::Vector2d> ReachableFloor(const Floor& floor, const FloorCoverOptions& options) {
  FreeCells cells = CellsAround(floor, options);
  for (const FloorWall& face : floor.faces) Block(face, options.radius, cells);
  std::deque<std::pair<int, int>> open{StartCell(floor, cells)};
  cells.At(open.front().first, open.front().second) = 0;
  std::vector<Eigen::Vector2d> places;
  while (!open.empty()) {
    const auto [x, y] = open.front();
    open.pop_front();
    places.push_back(cells.Place(x, y));
    constexpr std::array<std::pair<int, int>, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    for (const auto& [dx, dy] : kSteps) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= cells.width || y + dy >= cells.height) continue;
      if (cells.At(x + dx, y + dy) == 0) continue;
      cells.At(x + dx, y + dy) = 0;
      open.emplace_back(x + dx, y + dy);
    }
  }
  return places;
}

std::vector<Eigen::Vector2d> Thinned(const std::vector<Eigen::Vector2d>& places, double spacing) {
  std::set<std::pair<long, long>> taken;
  std::vector<Eigen::Vector2d> thinned;
  for (const Eigen::Vector2d& p : places) {
    const std::pair square(std::lround(p.x() / spacing), std::lround(p.y() / spacing));
    if (taken.insert(square).second) thinned.push_back(p);
  }
  return thinned;
}

FloorCover FindFloorCover(const Floor& floor, const std::vector<Eigen::Vector2d>& reachable,
                          const FloorScannerOptions& scanner, const FloorCoverOptions& options,
                          const Parallel& parallel) {
  FloorScannerOptions around = scanner;
  around.field_of_view = 360.0;
  const FloorCover samples = SampleWalls(floor, options.sample_spacing);
  const std::vector<Eigen::Vector2d> viewpoints = Thinned(reachable, options.place_spacing);
  std::vector<std::vector<std::uint32_t>> seen_from(viewpoints.size());
  parallel.For(viewpoints.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    seen_from[i] = SeenPlaces(ViewFloor(floor, {0.0, viewpoints[i]}, around), samples, around);
  });
  std::vector<bool> seen(samples.places_map.size(), false);
  for (const auto& places : seen_from) {
    for (const std::uint32_t k : places) seen[k] = true;
  }
  FloorCover cover{{}, samples.length_each};
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k]) cover.places_map.push_back(samples.places_map[k]);
  }
  return cover;
}

std::vector<std::uint32_t> SeenPlaces(const FloorView& view, const FloorCover& cover,
                                      const FloorScannerOptions& scanner) {
  std::vector<std::uint32_t> seen;
  for (std::size_t k = 0; k < cover.places_map.size(); ++k) {
    const Eigen::Vector2d& p = cover.places_map[k];
    if ((p - view.T_map_scan.translation).squaredNorm() > scanner.max_range * scanner.max_range) continue;
    if (IsSeen(view, p)) seen.push_back(static_cast<std::uint32_t>(k));
  }
  return seen;
}

}  // namespace ariadne::experiments
