#include "experiments/mission/mission_map.h"

#include <algorithm>
#include <cmath>

#include "experiments/mission/fence.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

constexpr double kOwnRadius = 0.28;  // within the robot's own outline, where it has stood [m]

constexpr double kFarBeam = 30.0;  // [m]

bool HasStoodAt(std::span<const slam::Pose2> T_map_bases, const Eigen::Vector2d& p_map) {
  return std::ranges::any_of(T_map_bases, [&](const slam::Pose2& T_map_base) {
    return (T_map_base.translation - p_map).norm() < kOwnRadius;
  });
}

bool IsOccupied(const slam::OccupancyGrid& grid, std::size_t column, std::size_t row) {
  return grid.At(column, row) == slam::Occupancy::kOccupied;
}

/// Whether all around a cell is occupied too, so that nothing can get to it without touching others.
bool IsInside(const slam::OccupancyGrid& grid, std::size_t column, std::size_t row) {
  if (column == 0 || row == 0 || column + 1 == grid.columns || row + 1 == grid.rows) return false;
  for (std::size_t r = row - 1; r <= row + 1; ++r) {
    for (std::size_t c = column - 1; c <= column + 1; ++c) {
      if (!IsOccupied(grid, c, r)) return false;
    }
  }
  return true;
}

/// Whether a scan's cells are still right, to a quarter of one at its farthest beams.
bool LiesThere(const slam::Pose3& T_map_then, const slam::Pose3& T_map_now,
               const slam::OccupancyGridOptions& options) {
  const slam::Pose3 T_then_now = T_map_then.Inverse() * T_map_now;
  const double turned = Eigen::AngleAxisd(T_then_now.rotation).angle();
  const double farthest = options.max_range > 0.0 ? options.max_range : kFarBeam;
  return T_then_now.translation.norm() + turned * farthest < 0.25 * options.resolution;
}

/// The centres of the occupied cells, but for those inside of what is occupied.
std::vector<Eigen::Vector2d> OccupiedPlaces(const slam::OccupancyGrid& grid) {
  std::vector<Eigen::Vector2d> places;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (!IsOccupied(grid, column, row) || IsInside(grid, column, row)) continue;
      const Eigen::Vector2d cell(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      places.emplace_back(grid.origin_map + grid.resolution * cell);
    }
  }
  return places;
}

}  // namespace

MissionMap::MissionMap(const MissionOptions& options, const slam::Pose3& T_base_laser)
    : options_(options),
      T_base_laser_(T_base_laser),
      mapper_(options.mapper),
      area_(options.area, ParseNumbers(options.heights, "heights"), T_base_laser),
      fence_map_(FencePosts(options.limits.fence, options.obstacles.resolution)) {
  CheckOptions(options_, "mission.");
}

slam::MatchResult MissionMap::AddScan(const std::string& name, slam::PointCloud cloud_laser,
                                      const slam::Pose2& T_map_base_guess) {
  const slam::Pose3 T_map_laser_guess = slam::ToPose3(T_map_base_guess) * T_base_laser_;
  T_chain_laser_ =
      scans_.empty() ? T_map_laser_guess
                     : T_chain_laser_ * (mapper_.scans().back().T_map_laser.Inverse() * T_map_laser_guess);
  slam::PosedCloud scan{name, std::move(cloud_laser), T_chain_laser_};
  slam::MatchResult match = mapper_.AddScan(scan);
  scan.T_map_laser = mapper_.scans().back().T_map_laser;
  if (mapper_.scans().back().registered) {
    shown_.push_back(scans_.size());
    area_.AddScan(scan);
  }
  scans_.push_back(std::move(scan));
  return match;
}

slam::Pose2 MissionMap::T_map_base(std::size_t scan) const {
  return FromAbove(mapper_.scans()[scan].T_map_laser * T_base_laser_.Inverse());
}

std::vector<slam::Pose3> MissionMap::T_map_laser() const {
  std::vector<slam::Pose3> poses;
  for (const slam::MapScan& scan : mapper_.scans()) poses.push_back(scan.T_map_laser);
  return poses;
}

std::vector<slam::PosedCloud> MissionMap::Scans() const {
  std::vector<slam::PosedCloud> scans = scans_;
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i].T_map_laser = mapper_.scans()[i].T_map_laser;
  return scans;
}

slam::PosedCloud MissionMap::LastScan() const {
  slam::PosedCloud scan = scans_.back();
  scan.T_map_laser = mapper_.scans().back().T_map_laser;
  return scan;
}

std::vector<slam::Pose3> MissionMap::RegisteredPoses() const {
  std::vector<slam::Pose3> poses;
  for (const std::size_t i : shown_) poses.push_back(mapper_.scans()[i].T_map_laser);
  return poses;
}

std::vector<slam::Pose2> MissionMap::T_map_scans() const {
  std::vector<slam::Pose2> poses;
  for (const slam::Pose3& T_map_laser : RegisteredPoses()) poses.push_back(FromAbove(T_map_laser));
  return poses;
}

std::vector<planning::LabelledPolygon> MissionMap::Area(std::size_t height) const {
  return area_.At(height, RegisteredPoses());
}

std::vector<planning::LabelledPolygon> MissionMap::AreaToLookCloser(std::size_t height) const {
  return area_.ToLookCloser(Area(height), height, RegisteredPoses());
}

std::optional<slam::AlignModel> MissionMap::ModelAround(const Eigen::Vector2d& p_map, double reach) const {
  std::vector<std::size_t> members;
  for (const std::size_t i : shown_) {
    if ((mapper_.scans()[i].T_map_laser.translation.head<2>() - p_map).norm() < reach) members.push_back(i);
  }
  if (members.empty()) return {};
  return slam::UnionInMap(mapper_.scans(), members);
}

/// Made anew only for scans that lie elsewhere than when it was made: each one takes long.
void MissionMap::UpdateSeenCells() {
  const std::vector<slam::Pose3> poses = RegisteredPoses();
  seen_cells_.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!seen_cells_[i].part.box.isEmpty() &&
        LiesThere(seen_cells_[i].T_map_laser, poses[i], options_.obstacles))
      continue;
    slam::PosedCloud scan = scans_[shown_[i]];
    scan.T_map_laser = poses[i];
    seen_cells_[i] = {poses[i], slam::MakeGridPart(scan, options_.obstacles)};
  }
}

slam::OccupancyGrid MissionMap::Grid() {
  UpdateSeenCells();
  slam::CellBox box;
  for (const SeenCells& seen : seen_cells_) box.extend(seen.part.box);
  slam::GridVotes votes(box, options_.obstacles);
  for (const SeenCells& seen : seen_cells_) votes.Meet(seen.part);
  for (const SeenCells& seen : seen_cells_) votes.Vote(seen.part);
  return std::move(votes).Finish();
}

std::vector<Eigen::Vector2d> MissionMap::Obstacles() {
  std::vector<slam::Pose2> T_map_bases;
  for (const std::size_t i : shown_) T_map_bases.push_back(T_map_base(i));
  std::vector<Eigen::Vector2d> obstacles = OccupiedPlaces(Grid());
  std::erase_if(obstacles, [&](const Eigen::Vector2d& p_map) { return HasStoodAt(T_map_bases, p_map); });
  obstacles.insert(obstacles.end(), met_map_.begin(), met_map_.end());
  obstacles.insert(obstacles.end(), fence_map_.begin(), fence_map_.end());
  return obstacles;
}

}  // namespace ariadne::experiments
