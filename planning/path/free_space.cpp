#include "planning/path/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "planning/path/distance_transform.h"

namespace ariadne::planning {
namespace {

constexpr double kMaxPlace = 1e7;   // [m]
constexpr double kLongPiece = 2.0;  // [m]; boxes around longer slanted edges hold mostly other cells
constexpr double kBin = 0.5;        // [m]
constexpr float kFar = std::numeric_limits<float>::infinity();

bool IsPlace(const Eigen::Vector2d& p) {
  return std::abs(p.x()) < kMaxPlace && std::abs(p.y()) < kMaxPlace;
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The first cell whose centre is at or beyond `at`, which is given from the first centre on [cells].
int FirstAt(double at, int count) { return static_cast<int>(std::clamp(std::ceil(at), 0.0, 1.0 * count)); }

}  // namespace

FreeSpace::FreeSpace(std::span<const slam::Polygon2> area, const FreeSpaceOptions& options,
                     std::span<const Eigen::Vector2d> obstacles_map)
    : resolution_(options.resolution), exact_within_(options.exact_within) {
  CheckOptions(options, "free_space.");
  const auto add = [this](const slam::Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  for (const slam::Polygon2& polygon : area) {
    add(polygon.outer);
    for (const slam::Ring& hole : polygon.holes) add(hole);
  }
  SetSize(options);
  if (squares_.empty()) return;
  AddObstacles(obstacles_map);
  // What seeds the transform must be known everywhere: which cells a boundary is in.
  const double reach = std::max(options.exact_within, resolution_);
  for (const Segment& edge : edges_) FindExactDistances(edge, reach);
  FindFarDistances(reach);
  MarkOutside();
  FillBins();
}

void FreeSpace::SetSize(const FreeSpaceOptions& options) {
  if (edges_.empty()) return;
  Eigen::Vector2d low = edges_.front().from, high = low;
  for (const Segment& edge : edges_) {
    if (!IsPlace(edge.from)) {
      Fail("the free area has the corner ({}, {}), which is no place within {} m", edge.from.x(),
           edge.from.y(), kMaxPlace);
    }
    low = low.cwiseMin(edge.from);
    high = high.cwiseMax(edge.from);
  }
  const Eigen::Vector2d size = ((high - low) / resolution_).array().ceil() + 2.0;  // a border of one cell
  if (size.x() * size.y() > options.max_cells) {
    Fail(
        "the free area of {:.1f} x {:.1f} m has {:.0f} cells of {} m, more than {}; raise "
        "free_space.resolution or free_space.max_cells",
        high.x() - low.x(), high.y() - low.y(), size.x() * size.y(), resolution_, options.max_cells);
  }
  columns_ = static_cast<int>(size.x());
  rows_ = static_cast<int>(size.y());
  lowest_ = low.array() - resolution_;
  squares_.assign(IndexOf({0, rows_}), kFar);
}

/// As edges without length, of those on the raster.
void FreeSpace::AddObstacles(std::span<const Eigen::Vector2d> obstacles_map) {
  for (const Eigen::Vector2d& p_map : obstacles_map) {
    if (!IsPlace(p_map))
      Fail("the free area has an obstacle at ({}, {}), which is no place", p_map.x(), p_map.y());
    if (IsOnRaster(CellOf(p_map))) edges_.push_back({p_map, p_map});
  }
}

void FreeSpace::FindExactDistances(const Segment& edge, double reach) {
  const Eigen::Vector2d along = edge.to - edge.from;
  const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / kLongPiece)));
  const Eigen::Vector2d first_centre = CentreOf({0, 0});
  for (int piece = 0; piece < pieces; ++piece) {
    const Eigen::Vector2d from = edge.from + along * piece / pieces - first_centre;
    const Eigen::Vector2d to = edge.from + along * (piece + 1) / pieces - first_centre;
    const double length = (to - from).norm();
    const Eigen::Vector2d direction =
        length > 0.0 ? Eigen::Vector2d((to - from) / length) : Eigen::Vector2d::Zero();
    const Eigen::Vector2d low = (from.cwiseMin(to).array() - reach) / resolution_;
    const Eigen::Vector2d high = (from.cwiseMax(to).array() + reach) / resolution_;
    const int begin = FirstAt(low.x(), columns_), end = FirstAt(high.x(), columns_);
    const auto cell = static_cast<float>(resolution_), longest = static_cast<float>(length);
    const auto ux = static_cast<float>(direction.x()), uy = static_cast<float>(direction.y());
    const int last_row = FirstAt(high.y(), rows_);
    for (int row = FirstAt(low.y(), rows_); row < last_row; ++row) {
      const auto y = static_cast<float>(row * resolution_ - from.y());
      const auto x0 = static_cast<float>(begin * resolution_ - from.x());
      float* squares = &squares_[IndexOf({begin, row})];
      for (int i = 0; i < end - begin; ++i) {  // a loop that compilers turn into vectors
        const float x = x0 + cell * static_cast<float>(i);
        const float t = std::min(std::max(x * ux + y * uy, 0.0f), longest);
        const float dx = x - t * ux, dy = y - t * uy;
        squares[i] = std::min(squares[i], dx * dx + dy * dy);
      }
    }
  }
}

void FreeSpace::FindFarDistances(double exact_within) {
  const double half_diagonal = resolution_ * std::numbers::sqrt2 / 2.0;
  // The cells that the boundary is in are among these.
  const auto near = static_cast<float>(half_diagonal * half_diagonal * 1.0001);
  std::vector<bool> marked(squares_.size());
  for (std::size_t i = 0; i < squares_.size(); ++i) marked[i] = squares_[i] <= near;
  const std::vector<float> cells = SquaredDistances(marked, columns_, rows_);
  const auto exact_square = static_cast<float>(exact_within * exact_within);
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    if (squares_[i] <= exact_square) continue;
    const double far = std::sqrt(static_cast<double>(cells[i])) * resolution_ - half_diagonal;
    const double lower = std::max(far, exact_within);
    squares_[i] = std::min(squares_[i], static_cast<float>(lower * lower));
  }
}

void FreeSpace::MarkOutside() {
  std::vector<std::pair<int, double>> crossings;  // row, and where its centre line meets an edge [cells]
  const Eigen::Vector2d first_centre = CentreOf({0, 0});
  for (const Segment& edge : edges_) {
    const Eigen::Vector2d from = (edge.from - first_centre) / resolution_;
    const Eigen::Vector2d to = (edge.to - first_centre) / resolution_;
    const int end = FirstAt(std::max(from.y(), to.y()), rows_);
    for (int row = FirstAt(std::min(from.y(), to.y()), rows_); row < end; ++row) {
      crossings.emplace_back(row, from.x() + (row - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
    }
  }
  std::ranges::sort(crossings);
  std::size_t next = 0;
  for (int row = 0; row < rows_; ++row) {
    bool inside = false;
    for (int column = 0; column < columns_;) {
      int end = columns_;
      if (next < crossings.size() && crossings[next].first == row)
        end = FirstAt(crossings[next++].second, columns_);
      if (!inside) {
        for (int i = column; i < end; ++i) squares_[IndexOf({i, row})] *= -1.0f;
      }
      column = std::max(column, end);
      inside = !inside;
    }
    while (next < crossings.size() && crossings[next].first == row) ++next;
  }
}

Cell FreeSpace::CellOf(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d at = ((p_map - lowest_) / resolution_).array().floor();
  if (!(std::abs(at.x()) < 1e9 && std::abs(at.y()) < 1e9)) return {-1, -1};  // far away, and NaN
  return {static_cast<int>(at.x()), static_cast<int>(at.y())};
}

Eigen::Vector2d FreeSpace::CentreOf(Cell cell) const {
  return lowest_ + resolution_ * Eigen::Vector2d(cell.column + 0.5, cell.row + 0.5);
}

double FreeSpace::ClearanceAt(Cell cell) const {
  return std::sqrt(std::max(0.0, static_cast<double>(squares_[IndexOf(cell)])));
}

double FreeSpace::Clearance(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d at = (p_map - lowest_).array() / resolution_ - 0.5;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < columns_ - 1 && at.y() < rows_ - 1)) return 0.0;
  const Cell low{static_cast<int>(at.x()), static_cast<int>(at.y())};
  const double s = at.x() - low.column, t = at.y() - low.row;
  const std::size_t i = IndexOf(low), above = i + static_cast<std::size_t>(columns_);
  const std::array<double, 4> squares{squares_[i], squares_[i + 1], squares_[above], squares_[above + 1]};
  // A centre tells the side on which p is, unless a boundary may be between.
  const double cell_square = resolution_ * resolution_;
  const double left = s * s, right = (1.0 - s) * (1.0 - s), down = t * t, up = (1.0 - t) * (1.0 - t);
  const bool inside = squares[0] > cell_square * (left + down) ||
                      squares[1] > cell_square * (right + down) || squares[2] > cell_square * (left + up) ||
                      squares[3] > cell_square * (right + up);
  if (!inside) return 0.0;
  const double mean = (1.0 - t) * ((1.0 - s) * std::abs(squares[0]) + s * std::abs(squares[1])) +
                      t * ((1.0 - s) * std::abs(squares[2]) + s * std::abs(squares[3]));
  const double spread = cell_square * (s * (1.0 - s) + t * (1.0 - t));
  return std::sqrt(std::max(0.0, mean - spread));
}

FreeSpace::Bin FreeSpace::BinOf(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d at = ((p_map - lowest_) / kBin).array().floor();
  return {static_cast<int>(std::clamp(at.x(), 0.0, bin_columns_ - 1.0)),
          static_cast<int>(std::clamp(at.y(), 0.0, bin_rows_ - 1.0))};
}

void FreeSpace::FillBins() {
  bin_columns_ = static_cast<int>(std::ceil(columns_ * resolution_ / kBin));
  bin_rows_ = static_cast<int>(std::ceil(rows_ * resolution_ / kBin));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entries;  // bin, edge
  for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
    const Eigen::Vector2d from = edges_[edge].from, along = edges_[edge].to - from;
    const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / kBin)));
    for (int i = 0; i < pieces; ++i) {
      const Eigen::Vector2d a = from + along * i / pieces, b = from + along * (i + 1) / pieces;
      // Pieces meet in rounded places; a little more than the box holds them.
      const Bin low = BinOf(a.cwiseMin(b).array() - 1e-6), high = BinOf(a.cwiseMax(b).array() + 1e-6);
      for (int row = low.row; row <= high.row; ++row) {
        for (int column = low.column; column <= high.column; ++column) {
          entries.emplace_back(row * bin_columns_ + column, edge);
        }
      }
    }
  }
  std::ranges::sort(entries);
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  bin_begin_.assign(static_cast<std::size_t>(bin_columns_) * static_cast<std::size_t>(bin_rows_) + 1, 0);
  for (const auto& entry : entries) {
    ++bin_begin_[entry.first + 1];
    bin_edges_.push_back(entry.second);
  }
  std::partial_sum(bin_begin_.begin(), bin_begin_.end(), bin_begin_.begin());
}

bool FreeSpace::IsFarFromEdges(const Eigen::Vector2d& p_map, double radius) const {
  const Bin low = BinOf(p_map.array() - radius), high = BinOf(p_map.array() + radius);
  for (int row = low.row; row <= high.row; ++row) {
    const auto bins = static_cast<std::size_t>(row) * static_cast<std::size_t>(bin_columns_);
    const std::uint32_t end = bin_begin_[bins + static_cast<std::size_t>(high.column) + 1];
    for (std::uint32_t i = bin_begin_[bins + static_cast<std::size_t>(low.column)]; i < end; ++i) {
      const Segment& edge = edges_[bin_edges_[i]];
      const Eigen::Vector2d along = edge.to - edge.from;
      const double square = along.squaredNorm();
      const double t = square > 0.0 ? std::clamp((p_map - edge.from).dot(along) / square, 0.0, 1.0) : 0.0;
      if ((edge.from + t * along - p_map).squaredNorm() < radius * radius) return false;
    }
  }
  return true;
}

bool FreeSpace::IsFree(const Eigen::Vector2d& p_map, double radius) const {
  const double clearance = Clearance(p_map);
  if (clearance >= radius) return true;
  const double most = clearance + resolution_ * std::numbers::sqrt2 / 2.0;
  if (clearance == 0.0 || most < radius || radius > exact_within_) return false;
  return IsFarFromEdges(p_map, radius);
}

bool FreeSpace::IsWayFree(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map,
                          double radius) const {
  const Eigen::Vector2d way = to_map - from_map;
  const double length = way.norm();
  if (!IsFree(to_map, radius)) return false;
  for (double at = 0.0; at < length;) {
    const Eigen::Vector2d p = from_map + at / length * way;
    if (!IsFree(p, radius)) return false;
    at += std::max(Clearance(p) - radius, 0.25 * resolution_);
  }
  return true;
}

bool FreeSpace::Contains(const Eigen::Vector2d& p_map) const {
  bool inside = false;
  for (const Segment& edge : edges_) {
    if ((edge.from.y() > p_map.y()) == (edge.to.y() > p_map.y())) continue;
    const double share = (p_map.y() - edge.from.y()) / (edge.to.y() - edge.from.y());
    if (p_map.x() < edge.from.x() + share * (edge.to.x() - edge.from.x())) inside = !inside;
  }
  return inside;
}

int FreeSpace::CountCrossings(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map) const {
  const Eigen::Vector2d way = to_map - from_map;
  int count = 0;
  for (const Segment& edge : edges_) {
    const Eigen::Vector2d along = edge.to - edge.from;
    const bool apart = (Cross(way, edge.from - from_map) > 0.0) != (Cross(way, edge.to - from_map) > 0.0);
    count +=
        apart && (Cross(along, from_map - edge.from) > 0.0) != (Cross(along, to_map - edge.from) > 0.0);
  }
  return count;
}

}  // namespace ariadne::planning
