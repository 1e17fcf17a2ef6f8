#include "planning/path/pose_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

constexpr int kHeadings = 36;
constexpr double kHeadingStep = 2.0 * std::numbers::pi / kHeadings;
constexpr std::uint32_t kTurnCost = 600;  // [cells / 1024]; 10 deg move the robot's corners by a cell
constexpr double kAlong = 0.86;           // cosine of what a step may differ from the heading, 30 deg
constexpr std::size_t kMostPoses = 100'000'000;  // 700 MB; 140 x 140 m of 10 cm
constexpr int kNearEnds = 2;                     // [cells], [headings]
constexpr std::size_t kPocket = 1'000'000;       // poses; a room of 70 m^2 with cells of 5 cm

struct RasterPose {
  Cell cell;
  int heading = 0;
};

/// From one pose of the raster to the next; none: a start.
struct Move {
  std::int8_t column = 0, row = 0, turn = 0;
};

constexpr std::uint32_t kUnknown = UINT32_MAX, kNotFree = 0, kStartCost = 1;

/// Dijkstra's, over arrays: most searches look at millions of poses, and find that there is no way.
class PoseSearch {
 public:
  PoseSearch(const FreeSpace& space, const Footprint& footprint);

  std::vector<slam::Pose2> Find(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                std::size_t most);
  std::vector<bool> Reach(const slam::Pose2& T_map_start, std::span<const slam::Pose2> T_map_goals);

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
  bool CanTurnIn(const Cell& cell) const;
  bool IsFree(const RasterPose& pose) const;
  std::vector<std::uint64_t> Around(const slam::Pose2& T_map_robot) const;
  /// Calls `visit` with each pose one move away, what the move costs, and it.
  template <typename Visitor>
  void ForEachNext(const RasterPose& pose, const Visitor& visit) const;
  void Visit(const RasterPose& pose, std::uint32_t cost, const Move& move);
  std::optional<std::uint64_t> TakeNext(std::size_t most);
  template <typename Look>
  void LookBeside(const Cell& cell, const Look& look_at) const;
  std::vector<std::uint64_t> Spread(std::vector<std::uint64_t> open, std::size_t most);
  bool IsShutIn(const std::vector<std::uint64_t>& goals, const std::vector<std::uint64_t>& starts);
  RasterPose Before(const RasterPose& pose) const;
  void Expand(std::uint64_t number);

  const FreeSpace& space_;
  const Footprint& footprint_;
  std::array<Eigen::Vector2d, kHeadings> axes_;
  std::vector<std::uint32_t> costs_;  // of all poses
  std::vector<Move> moves_;           // that led to each
  std::size_t visited_ = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

PoseSearch::PoseSearch(const FreeSpace& space, const Footprint& footprint)
    : space_(space), footprint_(footprint) {
  const auto cells = static_cast<std::size_t>(space.columns()) * static_cast<std::size_t>(space.rows());
  costs_.assign(cells * kHeadings, kUnknown);
  moves_.resize(costs_.size());
  for (int heading = 0; heading < kHeadings; ++heading) {
    const double angle = InMap({{}, heading}).angle;
    axes_[static_cast<std::size_t>(heading)] = {std::cos(angle), std::sin(angle)};
  }
}

bool PoseSearch::CanTurnIn(const Cell& cell) const {
  return space_.ClearanceAt(cell) >= footprint_.reach() + footprint_.options().margin;
}

bool PoseSearch::IsFree(const RasterPose& pose) const {
  if (!space_.IsOnRaster(pose.cell)) return false;
  if (CanTurnIn(pose.cell)) return true;
  return footprint_.IsFree(space_, space_.CentreOf(pose.cell),
                           axes_[static_cast<std::size_t>(pose.heading)]);
}

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

void PoseSearch::Visit(const RasterPose& pose, std::uint32_t cost, const Move& move) {
  if (!space_.IsOnRaster(pose.cell)) return;
  const std::uint64_t number = NumberOf(pose);
  std::uint32_t& known = costs_[number];
  if (known <= cost) return;
  if (known == kUnknown) {
    ++visited_;
    if (!IsFree(pose)) {
      known = kNotFree;
      return;
    }
  }
  known = cost;
  moves_[number] = move;
  open_.emplace(cost, number);
}

RasterPose PoseSearch::Before(const RasterPose& pose) const {
  const Move& move = moves_[NumberOf(pose)];
  return {{pose.cell.column - move.column, pose.cell.row - move.row},
          (pose.heading - move.turn + kHeadings) % kHeadings};
}

template <typename Visitor>
void PoseSearch::ForEachNext(const RasterPose& pose, const Visitor& visit) const {
  for (const std::int8_t turn : {std::int8_t{1}, std::int8_t{-1}}) {
    visit(RasterPose{pose.cell, (pose.heading + turn + kHeadings) % kHeadings}, kTurnCost,
          Move{0, 0, turn});
  }
  const Eigen::Vector2d& axis = axes_[static_cast<std::size_t>(pose.heading)];
  for (std::int8_t row = -1; row <= 1; ++row) {
    for (std::int8_t column = -1; column <= 1; ++column) {
      const Eigen::Vector2d step(column, row);
      if (step.isZero() || std::abs(step.dot(axis)) < kAlong * step.norm()) continue;
      const auto length = static_cast<std::uint32_t>(1024.0 * step.norm());
      visit(RasterPose{{pose.cell.column + column, pose.cell.row + row}, pose.heading}, length,
            Move{column, row, 0});
    }
  }
}

void PoseSearch::Expand(std::uint64_t number) {
  const std::uint32_t cost = costs_[number];
  ForEachNext(PoseOf(number), [&](const RasterPose& next, std::uint32_t step, const Move& move) {
    Visit(next, cost + step, move);
  });
}

/// The nearest pose that was not left yet; none: all were, or enough.
std::optional<std::uint64_t> PoseSearch::TakeNext(std::size_t most) {
  while (!open_.empty() && visited_ <= most) {
    const auto [cost, number] = open_.top();
    open_.pop();
    if (costs_[number] == cost) return number;  // else reached by a shorter way since
  }
  return {};
}

/// Looks at the poses that moves lead to from a place where the robot can turn: one of each place beside it
/// where it can turn too.
template <typename Look>
void PoseSearch::LookBeside(const Cell& cell, const Look& look_at) const {
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      const Cell beside{cell.column + column, cell.row + row};
      const Eigen::Vector2d step(column, row);
      if (step.isZero() || !space_.IsOnRaster(beside)) continue;
      const bool one_will_do = CanTurnIn(beside);
      for (int heading = 0; heading < kHeadings; ++heading) {
        if (std::abs(step.dot(axes_[static_cast<std::size_t>(heading)])) < kAlong * step.norm()) continue;
        look_at(RasterPose{beside, heading});
        if (one_will_do) break;
      }
    }
  }
}

/// Marks the poses that moves lead to from these, without Dijkstra's order, until it has looked at `most`;
/// returns all that it has looked at. Where the robot can turn all round, one heading is as good as all,
/// and moves are looked at by places.
std::vector<std::uint64_t> PoseSearch::Spread(std::vector<std::uint64_t> open, std::size_t most) {
  std::vector<std::uint64_t> looked_at = open;
  for (const std::uint64_t number : open) costs_[number] = kStartCost;
  const auto look_at = [&](const RasterPose& next) {
    if (!space_.IsOnRaster(next.cell) || costs_[NumberOf(next)] != kUnknown) return;
    looked_at.push_back(NumberOf(next));
    costs_[NumberOf(next)] = IsFree(next) ? kStartCost : kNotFree;
    if (costs_[NumberOf(next)] == kStartCost) open.push_back(NumberOf(next));
  };
  while (!open.empty() && looked_at.size() < most) {
    const RasterPose pose = PoseOf(open.back());
    open.pop_back();
    if (!CanTurnIn(pose.cell)) {
      ForEachNext(pose, [&](const RasterPose& next, std::uint32_t, const Move&) { look_at(next); });
      continue;
    }
    const auto first = open.size();
    for (int turn = 1; turn < kHeadings; ++turn) look_at({pose.cell, (pose.heading + turn) % kHeadings});
    open.resize(first);
    LookBeside(pose.cell, look_at);
  }
  return looked_at;
}

/// Whether moves from the goals lead to few poses, none of them a start: Dijkstra's search, which would
/// look at all but these, need not begin.
bool PoseSearch::IsShutIn(const std::vector<std::uint64_t>& goals,
                          const std::vector<std::uint64_t>& starts) {
  const std::vector<std::uint64_t> pocket = Spread(goals, kPocket);
  const bool shut_in = pocket.size() < kPocket && std::ranges::none_of(starts, [&](std::uint64_t number) {
                         return costs_[number] == kStartCost;
                       });
  for (const std::uint64_t number : pocket) costs_[number] = kUnknown;
  return shut_in;
}

std::vector<bool> PoseSearch::Reach(const slam::Pose2& T_map_start,
                                    std::span<const slam::Pose2> T_map_goals) {
  Spread(Around(T_map_start), std::numeric_limits<std::size_t>::max());
  std::vector<bool> reached;
  for (const slam::Pose2& goal : T_map_goals) {
    reached.push_back(std::ranges::any_of(
        Around(goal), [&](std::uint64_t number) { return costs_[number] == kStartCost; }));
  }
  return reached;
}

std::vector<slam::Pose2> PoseSearch::Find(const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                          std::size_t most) {
  const std::vector<std::uint64_t> goals = Around(T_map_goal);
  const std::vector<std::uint64_t> starts = Around(T_map_start);
  if (goals.empty() || IsShutIn(goals, starts)) return {};
  for (const std::uint64_t number : starts) Visit(PoseOf(number), kStartCost, {});
  while (const auto next = TakeNext(most)) {
    const std::uint64_t number = *next;
    if (std::ranges::find(goals, number) == goals.end()) {
      Expand(number);
      continue;
    }
    std::vector<slam::Pose2> poses{InMap(PoseOf(number))};
    for (RasterPose at = PoseOf(number); costs_[NumberOf(at)] > kStartCost;) {
      at = Before(at);
      poses.push_back(InMap(at));
    }
    std::ranges::reverse(poses);
    return poses;
  }
  return {};
}

bool IsTooLarge(const FreeSpace& space) {
  const auto cells = static_cast<std::size_t>(space.columns()) * static_cast<std::size_t>(space.rows());
  return cells * kHeadings > kMostPoses;
}

}  // namespace

std::vector<slam::Pose2> PosesOnRaster(const FreeSpace& space, const Footprint& footprint,
                                       const slam::Pose2& T_map_start, const slam::Pose2& T_map_goal,
                                       std::size_t most) {
  if (IsTooLarge(space)) return {};
  return PoseSearch(space, footprint).Find(T_map_start, T_map_goal, most);
}

std::vector<bool> GoalsOnRaster(const FreeSpace& space, const Footprint& footprint,
                                const slam::Pose2& T_map_start, std::span<const slam::Pose2> T_map_goals) {
  if (IsTooLarge(space)) return std::vector<bool>(T_map_goals.size(), true);
  return PoseSearch(space, footprint).Reach(T_map_start, T_map_goals);
}

}  // namespace ariadne::planning::internal
