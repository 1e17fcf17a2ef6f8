#include "experiments/mission/next_drive.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "experiments/mission/drive_ways.h"
#include "experiments/mission/way_back.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kSameTarget = 0.5;     // [m]
constexpr double kSameView = 0.15;      // [m]
constexpr double kSameDirection = 0.1;  // [rad]
constexpr int kGivenUp = 2;             // drives to one place
constexpr double kSameRoom = 4.0;       // that the way of a disc does not lead into [m]

/// A view that is worth a drive.
struct RankedView {
  planning::View view;
  std::size_t height = 0;
};

bool HasFailed(const Eigen::Vector2d& p_map, std::span<const FailedTarget> failed) {
  return std::ranges::any_of(failed, [&](const FailedTarget& target) {
    return !target.of_disc && target.times >= kGivenUp && (target.p_map - p_map).norm() < kSameTarget;
  });
}

/// Whether ways of a disc to near it have failed.
bool IsClosed(const Eigen::Vector2d& p_map, std::span<const FailedTarget> failed) {
  int times = 0;
  for (const FailedTarget& target : failed) {
    if (target.of_disc && (target.p_map - p_map).norm() < kSameRoom) times += target.times;
  }
  return times >= kGivenUp;
}

/// Whether the robot has scanned from there already, looking the same way: once more shows the same.
bool IsRepeated(const planning::View& view, std::span<const Pose2> T_map_stops) {
  return std::ranges::any_of(T_map_stops, [&](const Pose2& stop) {
    return (stop.translation - view.p_map).norm() < kSameView &&
           std::abs(slam::WrapAngle(stop.angle - view.direction)) < kSameDirection;
  });
}

/// The views of all heights, the best first; of those close to each other only the best.
std::vector<RankedView> RankViews(const Surroundings& around, const Pose2& T_map_base,
                                  std::span<const FailedTarget> failed, const MissionOptions& options,
                                  std::uint64_t seed) {
  std::vector<RankedView> ranked;
  for (std::size_t h = 0; h < around.areas.size(); ++h) {
    const planning::ViewPlan plan = planning::PlanNextView(
        around.areas[h], T_map_base, options.planner, seed, around.T_map_scans, {}, around.obstacles_map);
    if (!plan.chosen) continue;
    std::vector<std::size_t> order(plan.views.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return plan.views[i].value; });
    std::erase(order, *plan.chosen);
    order.insert(order.begin(), *plan.chosen);
    for (const std::size_t i : order) {
      const planning::View& view = plan.views[i];
      const bool worth = view.gain >= options.planner.view.min_gain &&
                         view.overlap >= options.planner.min_overlap && std::isfinite(view.distance);
      if (IsRepeated(view, around.T_map_stops)) continue;
      if ((worth || i == *plan.chosen) && !HasFailed(view.p_map, failed)) ranked.push_back({view, h});
    }
  }
  std::ranges::stable_sort(ranked, std::greater{}, [](const RankedView& r) { return r.view.value; });
  std::vector<RankedView> apart;
  for (const RankedView& candidate : ranked) {
    const bool known = std::ranges::any_of(apart, [&](const RankedView& other) {
      return (other.view.p_map - candidate.view.p_map).norm() < kSameTarget;
    });
    if (!known) apart.push_back(candidate);
  }
  return apart;
}

/// For views that the raster shows no path to: there may be one that is narrow to a cell, and hardly ever
/// is.
MissionOptions Hasty(const MissionOptions& options) {
  constexpr int kFewIterations = 400;
  MissionOptions hasty = options;
  hasty.path.max_iterations = std::min(kFewIterations, options.path.max_iterations);
  return hasty;
}

/// Views by their ranks, and what leads to them.
class RankedDrives {
 public:
  RankedDrives(const Surroundings& around, const Pose2& T_map_base, std::vector<RankedView> ranked,
               const MissionOptions& options, std::uint64_t seed)
      : around_(around),
        T_map_base_(T_map_base),
        ranked_(std::move(ranked)),
        options_(options),
        seed_(seed) {
    for (std::size_t h = 0; h < around.areas.size(); ++h)
      spaces_.push_back(SpacesAt(around, h, T_map_base, options.planner.free_space));
  }

  std::vector<std::size_t> All() const {
    std::vector<std::size_t> ranks(ranked_.size());
    for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] = i;
    return ranks;
  }

  /// By the best way that one of the best few has.
  std::optional<PlannedDrive> ByPath(std::span<const std::size_t> ranks,
                                     const MissionOptions& options) const {
    std::optional<PlannedDrive> drive;
    const auto attempt = [&](const PlanDrive& plan_drive) {
      for (const std::size_t rank : ranks.first(std::min(ranks.size(), BestFew()))) {
        if (drive) return;
        const Spaces& spaces = spaces_[ranked_[rank].height];
        drive = To(rank, plan_drive(spaces, GoalOf(rank)));
      }
    };
    TryWays(around_, T_map_base_, options, seed_, attempt);
    return drive;
  }

  std::optional<PlannedDrive> OfDisc(std::span<const FailedTarget> failed) const {
    std::size_t tried = 0;
    for (std::size_t rank = 0; rank < ranked_.size() && tried < BestFew(); ++rank) {
      if (IsClosed(ranked_[rank].view.p_map, failed)) continue;
      ++tried;
      const planning::FreeSpace& space = spaces_[ranked_[rank].height].free;
      if (auto drive = To(rank, DriveOfDisc(space, T_map_base_, GoalOf(rank), options_))) return drive;
    }
    return {};
  }

  /// Those that there may be a path to: one search for all of them takes as long as one path that is not
  /// found.
  std::vector<std::size_t> Reachable() const {
    std::vector<std::size_t> reachable;
    for (std::size_t h = 0; h < spaces_.size(); ++h) {
      std::vector<std::size_t> ranks;
      std::vector<Pose2> goals;
      for (std::size_t rank = 0; rank < ranked_.size(); ++rank) {
        if (ranked_[rank].height == h) ranks.push_back(rank), goals.push_back(GoalOf(rank));
      }
      if (ranks.empty()) continue;
      const std::vector<bool> may = MayHaveAPath(spaces_[h], around_, T_map_base_, goals, options_);
      for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (may[i]) reachable.push_back(ranks[i]);
      }
    }
    std::ranges::sort(reachable);
    return reachable;
  }

 private:
  std::size_t BestFew() const { return static_cast<std::size_t>(options_.patience.targets); }
  Pose2 GoalOf(std::size_t rank) const {
    const planning::View& view = ranked_[rank].view;
    return {view.direction, view.p_map};
  }
  std::optional<PlannedDrive> To(std::size_t rank, std::optional<PlannedDrive> drive) const {
    if (drive) drive->view = ranked_[rank].view, drive->height = ranked_[rank].height, drive->rank = rank;
    return drive;
  }

  const Surroundings& around_;
  const Pose2& T_map_base_;
  std::vector<RankedView> ranked_;
  const MissionOptions& options_;
  std::uint64_t seed_;
  std::vector<Spaces> spaces_;  // by height
};

}  // namespace

std::optional<PlannedDrive> PlanNextDrive(const Surroundings& around, const Pose2& T_map_base,
                                          std::span<const FailedTarget> failed,
                                          const MissionOptions& options, std::uint64_t seed) {
  const RankedDrives drives(around, T_map_base, RankViews(around, T_map_base, failed, options, seed),
                            options, seed);
  std::optional<PlannedDrive> drive;
  if (options.drive_by != DriveBy::kApproach) drive = drives.ByPath(drives.Reachable(), options);
  if (!drive) drive = drives.ByPath(drives.All(), Hasty(options));
  if (!drive) drive = drives.OfDisc(failed);
  return drive;
}

std::optional<PlannedDrive> PlanDriveTo(const Surroundings& around, const Pose2& T_map_base,
                                        const Pose2& T_map_goal, const MissionOptions& options,
                                        std::uint64_t seed) {
  const Spaces spaces = SpacesAt(around, 0, T_map_base, options.planner.free_space);
  std::optional<PlannedDrive> drive;
  TryWays(around, T_map_base, options, seed, [&](const auto& plan_drive) {
    if (!drive) drive = plan_drive(spaces, T_map_goal);
  });
  if (!drive) drive = DriveOfDisc(spaces.free, T_map_base, T_map_goal, options);
  return drive;
}

PlannedDrive PlanRetreat(std::span<const Pose2> trail_map, double away) {
  PlannedDrive drive;
  drive.path_map = WayBack(trail_map, away);
  drive.retraced = drive.path_map.size();
  return drive;
}

std::optional<PlannedDrive> PlanWayOut(const Surroundings& around, std::span<const FailedTarget> failed,
                                       const MissionOptions& options, std::uint64_t seed) {
  constexpr double kStep = 3.0, kFarthest = 12.0;  // [m]
  Surroundings there = around;
  there.trail_map.clear();  // it does not end there
  for (double away = kStep; away <= kFarthest; away += kStep) {
    PlannedDrive drive = PlanRetreat(around.trail_map, away);
    if (drive.path_map.size() < 2) return {};  // it has not moved yet
    if (PlanNextDrive(there, drive.path_map.back(), failed, options, seed)) return drive;
  }
  return {};
}

}  // namespace ariadne::experiments
