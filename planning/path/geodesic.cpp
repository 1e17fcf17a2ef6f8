#include "planning/path/geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::planning {
namespace {

constexpr double kUnitsPerCell = 1024.0;
constexpr double kLeastRadius = 0.75;  // [cells]
constexpr double kMaxLeave = 0.5;      // from a start without room [m]
constexpr double kMaxArrive = 2.0;     // [cells]
constexpr std::uint32_t kUnreached = UINT32_MAX;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// To a neighbour; the cells `by` are crossed on the way and must be free as well.
struct Step {
  Cell to;
  std::uint32_t length;  // [cells / 1024]
  std::array<Cell, 2> by;
};

constexpr std::array<Step, 16> MakeSteps() {
  std::array<Step, 16> steps{};
  std::size_t n = 0;
  for (const int a : {-1, 1}) {
    steps[n++] = {{a, 0}, 1024, {Cell{a, 0}, Cell{a, 0}}};
    steps[n++] = {{0, a}, 1024, {Cell{0, a}, Cell{0, a}}};
    for (const int b : {-1, 1}) {
      steps[n++] = {{a, b}, 1448, {Cell{a, 0}, Cell{0, b}}};
      steps[n++] = {{2 * a, b}, 2290, {Cell{a, 0}, Cell{a, b}}};
      steps[n++] = {{a, 2 * b}, 2290, {Cell{0, b}, Cell{a, b}}};
    }
  }
  return steps;
}
constexpr std::array<Step, 16> kSteps = MakeSteps();

/// The steps on one raster. A disc of 0.75 cells is never free in the two outermost rows and columns, so
/// that no step from a free cell leaves the raster.
class Stepper {
 public:
  Stepper(int columns, const std::vector<char>& free) : free_(free) {
    const auto offset = [columns](Cell cell) { return std::ptrdiff_t{cell.row} * columns + cell.column; };
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      to_[i] = offset(kSteps[i].to);
      by_[i] = {offset(kSteps[i].by[0]), offset(kSteps[i].by[1])};
    }
  }
  std::size_t Neighbour(std::size_t cell, std::size_t step) const { return Plus(cell, to_[step]); }
  bool IsOpen(std::size_t cell, std::size_t step) const {
    return free_[Plus(cell, by_[step][0])] && free_[Plus(cell, by_[step][1])] &&
           free_[Neighbour(cell, step)];
  }

 private:
  static std::size_t Plus(std::size_t cell, std::ptrdiff_t offset) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + offset);
  }
  const std::vector<char>& free_;
  std::array<std::ptrdiff_t, 16> to_;
  std::array<std::array<std::ptrdiff_t, 2>, 16> by_;
};

/// Buckets as wide as the shortest step: a cell in the nearest of them cannot become nearer (Dinitz 1978),
/// so that the order within a bucket does not matter.
class BucketQueue {
 public:
  void Push(std::uint32_t distance, std::size_t cell) {
    const std::size_t bucket = distance / kWidth;
    if (buckets_.size() <= bucket) buckets_.resize(bucket + 1);
    buckets_[bucket].push_back(static_cast<std::uint32_t>(cell));
  }

  /// Calls visit(cell) for the cells in the order of their buckets, also for those that visit() pushes;
  /// not for cells that have moved on to a nearer bucket.
  template <typename Visit>
  void Empty(const std::vector<std::uint32_t>& distance, Visit&& visit) {
    for (std::size_t next = 0; next < buckets_.size(); ++next) {
      const std::vector<std::uint32_t> cells = std::exchange(buckets_[next], {});
      for (const std::uint32_t cell : cells) {
        if (distance[cell] / kWidth == next) visit(cell);
      }
    }
  }

 private:
  static constexpr std::uint32_t kWidth = 1024;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

struct NearCell {
  double distance;  // [m]
  Cell cell;
};

/// Cells whose centres are within a distance of p, nearest first.
std::vector<NearCell> CellsAround(const FreeSpace& space, const Eigen::Vector2d& p_map, double within) {
  const Cell middle = space.CellOf(p_map);
  const int reach = static_cast<int>(std::ceil(within / space.resolution()));
  std::vector<NearCell> cells;
  for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (int column = middle.column - reach; column <= middle.column + reach; ++column) {
      const Cell cell{column, row};
      const double distance = (space.CentreOf(cell) - p_map).norm();
      if (space.IsOnRaster(cell) && distance <= within) cells.push_back({distance, cell});
    }
  }
  std::ranges::stable_sort(cells, {}, &NearCell::distance);
  return cells;
}

/// Free cells next to the start: within a cell of the nearest one.
std::vector<NearCell> LeaveStart(const FreeSpace& space, const std::vector<char>& free,
                                 const Eigen::Vector2d& start_map) {
  std::vector<NearCell> left;
  const int allowed = space.Contains(start_map) ? 0 : 1;
  const double within = std::max(kMaxLeave, kMaxArrive * space.resolution());
  for (const NearCell& near : CellsAround(space, start_map, within)) {
    if (!left.empty() && near.distance > left.front().distance + space.resolution()) break;
    if (!free[space.IndexOf(near.cell)]) continue;
    const bool same_side = space.ClearanceAt(near.cell) >= near.distance ||
                           space.CountCrossings(start_map, space.CentreOf(near.cell)) <= allowed;
    if (same_side) left.push_back(near);
  }
  return left;
}

/// Each corner of the way from where the line of sight from the corner before still reaches.
std::vector<Eigen::Vector2d> Tightened(const FreeSpace& space, const std::vector<Eigen::Vector2d>& way,
                                       double radius) {
  if (way.size() < 3) return way;
  std::vector<Eigen::Vector2d> tight{way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    std::size_t next = i + 1;
    while (next + 1 < way.size() && space.IsWayFree(way[i], way[next + 1], radius)) ++next;
    tight.push_back(way[next]);
    i = next;
  }
  return tight;
}

}  // namespace

GeodesicField::GeodesicField(const FreeSpace& space, const Eigen::Vector2d& start_map)
    : space_(&space), start_map_(start_map) {}

void GeodesicField::SpreadFromStart(double radius) {
  radius_ = std::max(radius, kLeastRadius * space_->resolution());
  const std::size_t size = space_->IndexOf({0, space_->rows()});
  free_.resize(size);
  distance_.assign(size, kUnreached);
  for (int row = 0; row < space_->rows(); ++row) {
    for (int column = 0; column < space_->columns(); ++column) {
      const Cell cell{column, row};
      free_[space_->IndexOf(cell)] = space_->ClearanceAt(cell) >= radius_;
    }
  }
  BucketQueue queue;
  for (const NearCell& near : LeaveStart(*space_, free_, start_map_)) {
    const std::size_t cell = space_->IndexOf(near.cell);
    distance_[cell] = static_cast<std::uint32_t>(near.distance / space_->resolution() * kUnitsPerCell);
    queue.Push(distance_[cell], cell);
  }
  const Stepper stepper(space_->columns(), free_);
  queue.Empty(distance_, [&](std::size_t cell) {
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      const std::size_t neighbour = stepper.Neighbour(cell, i);
      const std::uint32_t distance = distance_[cell] + kSteps[i].length;
      if (distance >= distance_[neighbour] || !stepper.IsOpen(cell, i)) continue;
      distance_[neighbour] = distance;
      queue.Push(distance, neighbour);
    }
  });
}

GeodesicField::Arrival GeodesicField::ArrivalAt(const Eigen::Vector2d& p_map) const {
  Arrival best{{}, kInfinity};
  for (const NearCell& near : CellsAround(*space_, p_map, kMaxArrive * space_->resolution())) {
    // Within the disc around the cell no boundary can be on the way.
    if (!IsReachable(near.cell) || space_->ClearanceAt(near.cell) < near.distance) continue;
    const double distance =
        distance_[space_->IndexOf(near.cell)] / kUnitsPerCell * space_->resolution() + near.distance;
    if (distance < best.distance) best = {near.cell, distance};
  }
  return best;
}

double GeodesicField::To(const Eigen::Vector2d& p_map) const {
  const double distance = ArrivalAt(p_map).distance;
  if (distance > 2.0 * kMaxArrive * space_->resolution()) return distance;
  // Next to the start, the way over centres of cells is a detour.
  const double straight = (p_map - start_map_).norm();
  return straight == 0.0 || space_->IsWayFree(start_map_, p_map, radius_) ? straight : distance;
}

std::vector<Eigen::Vector2d> GeodesicField::RasterPathTo(const Eigen::Vector2d& p_map) const {
  const Arrival arrival = ArrivalAt(p_map);
  if (arrival.distance == kInfinity) return {};
  const Stepper stepper(space_->columns(), free_);
  std::vector<Eigen::Vector2d> way{p_map};
  Cell at = arrival.cell;
  for (bool more = true; more;) {
    way.push_back(space_->CentreOf(at));
    const std::size_t cell = space_->IndexOf(at);
    more = false;
    for (std::size_t i = 0; i < kSteps.size() && !more; ++i) {  // a step leads as well back as there
      const std::uint32_t before = distance_[stepper.Neighbour(cell, i)];
      more =
          before != kUnreached && before + kSteps[i].length == distance_[cell] && stepper.IsOpen(cell, i);
      if (more) at = {at.column + kSteps[i].to.column, at.row + kSteps[i].to.row};
    }
  }
  way.push_back(start_map_);
  return way;
}

std::vector<Eigen::Vector2d> GeodesicField::PathTo(const Eigen::Vector2d& p_map) const {
  if (p_map == start_map_ && To(p_map) == 0.0) return {start_map_, p_map};
  // Once from each end: a corner is seen from both sides.
  std::vector<Eigen::Vector2d> way = Tightened(*space_, RasterPathTo(p_map), radius_);
  std::ranges::reverse(way);
  return Tightened(*space_, way, radius_);
}

GeodesicField DistancesFrom(const FreeSpace& space, const Eigen::Vector2d& start_map, double radius) {
  if (!start_map.allFinite()) Fail("the start ({}, {}) is no place", start_map.x(), start_map.y());
  if (!(radius >= 0.0 && radius < kInfinity)) {
    Fail("the robot's radius is {} m, but must be finite and not negative", radius);
  }
  GeodesicField field(space, start_map);
  field.SpreadFromStart(radius);
  return field;
}

double LengthOf(const std::vector<Eigen::Vector2d>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

}  // namespace ariadne::planning
