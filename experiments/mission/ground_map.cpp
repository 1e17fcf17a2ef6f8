#include "experiments/mission/ground_map.h"

#include <algorithm>
#include <cmath>

#include "slam/map/clear_cells.h"

namespace ariadne::experiments {
namespace {

constexpr double kOwnRadius = 0.28;      // within the robot's own outline, where it has stood [m]
constexpr double kFarBeam = 30.0;        // [m]
constexpr double kNearRobotWhole = 1.5;  // what is not clear; by leaving it, the robot opens its border [m]
constexpr double kLayerCount = 64.0;

bool HasStoodAt(std::span<const slam::Pose2> T_map_bases, const Eigen::Vector2d& p_map) {
  return std::ranges::any_of(T_map_bases, [&](const slam::Pose2& T_map_base) {
    return (T_map_base.translation - p_map).norm() < kOwnRadius;
  });
}

/// Whether a scan's cells are still right, to a quarter of one at its farthest beams.
bool LiesThere(const slam::Pose3& T_map_then, const slam::Pose3& T_map_now,
               const slam::OccupancyGridOptions& options) {
  const slam::Pose3 T_then_now = T_map_then.Inverse() * T_map_now;
  const double turned = Eigen::AngleAxisd(T_then_now.rotation).angle();
  const double farthest = options.max_range > 0.0 ? options.max_range : kFarBeam;
  return T_then_now.translation.norm() + turned * farthest < 0.25 * options.resolution;
}

/// Whether all around a cell is as it is, so that nothing can get to it without touching others.
template <typename Is>
bool IsInside(const slam::OccupancyGrid& grid, std::size_t column, std::size_t row, const Is& is) {
  if (column == 0 || row == 0 || column + 1 == grid.columns || row + 1 == grid.rows) return false;
  for (std::size_t r = row - 1; r <= row + 1; ++r) {
    for (std::size_t c = column - 1; c <= column + 1; ++c) {
      if (!is(c, r)) return false;
    }
  }
  return true;
}

/// The centres of the cells of some kind, but for those inside of what is of that kind, unless they are
/// near the robot, and but for where it has stood.
template <typename Is>
std::vector<Eigen::Vector2d> OutlinePlaces(const slam::OccupancyGrid& grid,
                                           std::span<const slam::Pose2> T_map_bases, double near,
                                           const Is& is) {
  std::vector<Eigen::Vector2d> places;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (!is(column, row)) continue;
      const Eigen::Vector2d cell(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      const Eigen::Vector2d p_map = grid.origin_map + grid.resolution * cell;
      const bool is_near = !T_map_bases.empty() && (T_map_bases.back().translation - p_map).norm() < near;
      if (!is_near && IsInside(grid, column, row, is)) continue;
      if (!HasStoodAt(T_map_bases, p_map)) places.push_back(p_map);
    }
  }
  return places;
}

/// Cells, by index, in which something may stand that no beam has met; none where gaps do not count.
std::vector<bool> ClearOf(const slam::GridVotes& votes, std::size_t columns,
                          const slam::OccupancyGridOptions& grid, const ClearOptions& clear) {
  const double layer = (grid.max_height - grid.min_height) / kLayerCount;
  const int gap = std::clamp(static_cast<int>(std::round(clear.gap / layer)), 1, 64);
  const int around = static_cast<int>(std::round(clear.within / grid.resolution));
  return slam::ClearCells(votes.passed(), columns, around, gap);
}

}  // namespace

void GroundMap::Update(std::span<const slam::PosedCloud> scans, std::span<const std::size_t> shown,
                       std::span<const slam::Pose3> T_map_laser) {
  seen_.resize(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!seen_[i].part.box.isEmpty() && LiesThere(seen_[i].T_map_laser, T_map_laser[i], grid_)) continue;
    slam::PosedCloud scan = scans[shown[i]];
    scan.T_map_laser = T_map_laser[i];
    seen_[i] = {T_map_laser[i], slam::MakeGridPart(scan, grid_)};
  }
}

Ground GroundMap::Look(std::span<const slam::PosedCloud> scans, std::span<const std::size_t> shown,
                       std::span<const slam::Pose3> T_map_laser, std::span<const slam::Pose2> T_map_base) {
  Update(scans, shown, T_map_laser);
  slam::CellBox box;
  for (const SeenCells& seen : seen_) box.extend(seen.part.box);
  slam::GridVotes votes(box, grid_);
  for (const SeenCells& seen : seen_) votes.Meet(seen.part);
  for (const SeenCells& seen : seen_) votes.Vote(seen.part);
  const auto columns = static_cast<std::size_t>(box.sizes().x() + 1);
  const std::vector<bool> clear =
      clear_.gap > 0.0 ? ClearOf(votes, columns, grid_, clear_) : std::vector<bool>();
  const slam::OccupancyGrid grid = std::move(votes).Finish();
  const auto occupied = [&](std::size_t column, std::size_t row) {
    return grid.At(column, row) == slam::Occupancy::kOccupied;
  };
  Ground ground;
  ground.obstacles_map = OutlinePlaces(grid, T_map_base, 0.0, occupied);
  ground.obstacles_map.insert(ground.obstacles_map.end(), met_map_.begin(), met_map_.end());
  ground.obstacles_map.insert(ground.obstacles_map.end(), fence_map_.begin(), fence_map_.end());
  if (clear.empty()) return ground;
  ground.unclear_map =
      OutlinePlaces(grid, T_map_base, kNearRobotWhole,
                    [&](std::size_t column, std::size_t row) { return !clear[row * columns + column]; });
  return ground;
}

}  // namespace ariadne::experiments
