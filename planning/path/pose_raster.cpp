#include "planning/path/pose_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>
#include <unordered_map>

#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

constexpr int kHeadings = 36;
constexpr double kHeadingStep = 2.0 * std::numbers::pi / kHeadings;
constexpr std::uint32_t kTurnCost = 600;  // [cells / 1024]; 10 deg move the robot's corners by a cell
constexpr double kAlong = 0.86;           // cosine of what a step may differ from the heading, 30 deg
constexpr int kNearEnds = 2;              // [cells], [headings]

struct RasterPose {
  Cell cell;
  int heading = 0;
};

/// What is known of a pose on the raster.
struct Visited {
  std::uint32_t cost = UINT32_MAX;
  std::uint64_t before = 0;
  bool is_closed = false;
};

class PoseSearch {
 public:
  PoseSearch(const FreeSpace& space, const Footprint& footprint) : space_(space), footprint_(footprint) {}

  std::vector<slam::Pose2> Find(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                std::size_t most);

 private:
  using Entry = std::pair<std::uint32_t, std::uint64_t>;  // cost, pose

  std::uint64_t NumberOf(const RasterPose& pose) const {
    return space_.IndexOf(pose.cell) * kHeadings + static_cast<std::uint64_t>(pose.heading);
  }
  RasterPose PoseOf(std::uint64_t number) const {
    const auto cell = static_cast<std::int64_t>(number / kHeadings);
    return {{static_cast<int>(cell % space_.columns()), static_cast<int>(cell / space_.columns())},
            static_cast<int>(number % kHeadings)};
  }
  slam::Pose2 InMap(const RasterPose& pose) const {
    return {slam::WrapAngle(pose.heading * kHeadingStep), space_.CentreOf(pose.cell)};
  }
  bool IsFree(const RasterPose& pose) const {
    return space_.IsOnRaster(pose.cell) && footprint_.IsFree(space_, InMap(pose));
  }
  std::vector<std::uint64_t> Around(const slam::Pose2& T_map_robot) const;
  void Reach(const RasterPose& pose, std::uint32_t cost, std::uint64_t before);
  void Expand(std::uint64_t number);

  const FreeSpace& space_;
  const Footprint& footprint_;
  std::unordered_map<std::uint64_t, Visited> visited_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// The poses of the raster next to a pose, in which the robot fits.
std::vector<std::uint64_t> PoseSearch::Around(const slam::Pose2& T_map_robot) const {
  const Cell middle = space_.CellOf(T_map_robot.translation);
  const auto heading = static_cast<int>(std::lround(T_map_robot.angle / kHeadingStep));
  std::vector<std::uint64_t> around;
  for (int row = -kNearEnds; row <= kNearEnds; ++row) {
    for (int column = -kNearEnds; column <= kNearEnds; ++column) {
      for (int turn = -kNearEnds; turn <= kNearEnds; ++turn) {
        const int wrapped = ((heading + turn) % kHeadings + kHeadings) % kHeadings;
        const RasterPose pose{{middle.column + column, middle.row + row}, wrapped};
        if (IsFree(pose)) around.push_back(NumberOf(pose));
      }
    }
  }
  return around;
}

void PoseSearch::Reach(const RasterPose& pose, std::uint32_t cost, std::uint64_t before) {
  const std::uint64_t number = NumberOf(pose);
  const auto found = visited_.find(number);
  if (found != visited_.end() && found->second.cost <= cost) return;
  if (found == visited_.end() && !IsFree(pose)) {
    visited_[number].cost = 0;  // never again
    return;
  }
  visited_[number] = {cost, before, false};
  open_.emplace(cost, number);
}

void PoseSearch::Expand(std::uint64_t number) {
  const RasterPose pose = PoseOf(number);
  const std::uint32_t cost = visited_[number].cost;
  for (const int turn : {1, kHeadings - 1}) {
    Reach({pose.cell, (pose.heading + turn) % kHeadings}, cost + kTurnCost, number);
  }
  const double angle = pose.heading * kHeadingStep;
  const Eigen::Vector2d axis(std::cos(angle), std::sin(angle));
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      const Eigen::Vector2d step(column, row);
      if (step.isZero() || std::abs(step.dot(axis)) < kAlong * step.norm()) continue;
      const auto length = static_cast<std::uint32_t>(1024.0 * step.norm());
      Reach({{pose.cell.column + column, pose.cell.row + row}, pose.heading}, cost + length, number);
    }
  }
}

std::vector<slam::Pose2> PoseSearch::Find(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                          std::size_t most) {
  const std::vector<std::uint64_t> goals = Around(T_map_goal);
  if (goals.empty()) return {};
  for (const std::uint64_t number : Around(T_map_start)) Reach(PoseOf(number), 1, number);
  while (!open_.empty() && visited_.size() <= most) {
    const auto [cost, number] = open_.top();
    open_.pop();
    Visited& visited = visited_[number];
    if (visited.is_closed || visited.cost != cost) continue;
    visited.is_closed = true;
    if (std::ranges::find(goals, number) == goals.end()) {
      Expand(number);
      continue;
    }
    std::vector<slam::Pose2> poses{InMap(PoseOf(number))};
    for (std::uint64_t at = number; visited_[at].before != at;) {
      at = visited_[at].before;
      poses.push_back(InMap(PoseOf(at)));
    }
    std::ranges::reverse(poses);
    return poses;
  }
  return {};
}

}  // namespace

std::vector<slam::Pose2> PosesOnRaster(const FreeSpace& space, const Footprint& footprint,
                                       const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                       std::size_t most) {
  return PoseSearch(space, footprint).Find(T_map_start, T_map_goal, most);
}

}  // namespace ariadne::planning::internal
