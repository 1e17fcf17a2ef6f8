#include "slam/extract/region_outline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ariadne::slam {
namespace {

/// Points of a region that follow each other in a slice.
struct Run {
  std::size_t row = 0;
  std::size_t right = 0, left = 0;       // columns of its ends
  std::vector<Eigen::Vector2d> corners;  // its points in the plane, from right to left
};

std::vector<Run> RunsOf(const PlanarSurface& surface, const PointCloud& cloud,
                        std::span<const std::size_t> points, const DirectionGrid& grid,
                        std::size_t max_missed) {
  std::vector<std::size_t> order(points.begin(), points.end());
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::pair(grid.row(i), grid.column(i)); });
  std::vector<Run> runs;
  for (const std::size_t i : order) {
    const bool goes_on = !runs.empty() && runs.back().row == grid.row(i) &&
                         grid.column(i) <= runs.back().left + 1 + max_missed;
    if (!goes_on) runs.push_back({grid.row(i), grid.column(i), grid.column(i), {}});
    runs.back().left = grid.column(i);
    runs.back().corners.push_back(InPlane(surface, cloud.positions[i]));
  }
  return runs;
}

/// The place of a run at a column, between its points.
Eigen::Vector2d At(const Run& run, std::size_t column) {
  if (run.left == run.right) return run.corners.front();
  const double share = static_cast<double>(std::clamp(column, run.right, run.left) - run.right) /
                       static_cast<double>(run.left - run.right);
  const double place = share * static_cast<double>(run.corners.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), run.corners.size() - 1);
  const std::size_t after = std::min(before + 1, run.corners.size() - 1);
  const double rest = place - static_cast<double>(before);
  return (1.0 - rest) * run.corners[before] + rest * run.corners[after];
}

/// Between two runs of successive slices, over the columns that both have. Where one run alone faces the
/// other, the ring takes all of both, so that slanted borders have no steps.
Ring Between(const Run& below, const Run& above) {
  const std::size_t right = std::max(below.right, above.right), left = std::min(below.left, above.left);
  return {At(below, right), At(below, left), At(above, left), At(above, right)};
}

Ring AllOf(const Run& below, const Run& above) {
  return {below.corners.front(), below.corners.back(), above.corners.back(), above.corners.front()};
}

bool Face(const Run& below, const Run& above) {
  return below.right <= above.left && above.right <= below.left;
}

/// Which squares hold points, row by row.
std::set<std::pair<std::int64_t, std::int64_t>> SquaresOf(const PlanarSurface& surface,
                                                          const PointCloud& cloud,
                                                          std::span<const std::size_t> points,
                                                          double cell) {
  std::set<std::pair<std::int64_t, std::int64_t>> squares;
  for (const std::size_t i : points) {
    const Eigen::Vector2d q = InPlane(surface, cloud.positions[i]) / cell;
    squares.emplace(std::llround(std::floor(q.y())), std::llround(std::floor(q.x())));
  }
  return squares;
}

}  // namespace

std::vector<Polygon2> OutlineOfRuns(const PlanarSurface& surface, const PointCloud& cloud_laser,
                                    std::span<const std::size_t> points, const DirectionGrid& grid,
                                    std::size_t max_missed) {
  const std::vector<Run> runs = RunsOf(surface, cloud_laser, points, grid, max_missed);
  std::vector<std::vector<std::size_t>> of_row(grid.rows() + max_missed + 2);
  for (std::size_t r = 0; r < runs.size(); ++r) of_row[runs[r].row].push_back(r);
  std::vector<Ring> rings;
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    std::size_t next = row + 1;  // the next slice that shows the region, if it is near
    while (next <= row + max_missed && of_row[next].empty()) ++next;
    for (const std::size_t below : of_row[row]) {
      for (const std::size_t above : of_row[next]) {
        if (!Face(runs[below], runs[above])) continue;
        const auto faces = [&](std::size_t run, const std::vector<std::size_t>& others) {
          return std::ranges::count_if(others, [&](std::size_t o) { return Face(runs[run], runs[o]); });
        };
        const bool alone = faces(below, of_row[next]) == 1 && faces(above, of_row[row]) == 1;
        rings.push_back(alone ? AllOf(runs[below], runs[above]) : Between(runs[below], runs[above]));
      }
    }
  }
  return United(rings);
}

std::vector<Polygon2> OutlineOfSquares(const PlanarSurface& surface, const PointCloud& cloud,
                                       std::span<const std::size_t> points, double cell) {
  std::vector<Ring> rings;
  const auto squares = SquaresOf(surface, cloud, points, cell);
  for (auto square = squares.begin(); square != squares.end();) {
    const auto [row, first] = *square;
    std::int64_t last = first;  // neighbours in a row are one rectangle
    for (++square; square != squares.end() && *square == std::pair(row, last + 1); ++square) ++last;
    const double left = cell * static_cast<double>(first), right = cell * static_cast<double>(last + 1);
    const double bottom = cell * static_cast<double>(row), top = bottom + cell;
    rings.push_back({{left, bottom}, {right, bottom}, {right, top}, {left, top}});
  }
  return United(rings);
}

}  // namespace ariadne::slam
