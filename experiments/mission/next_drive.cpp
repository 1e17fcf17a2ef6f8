#include "experiments/mission/next_drive.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/mission/drive_ways.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kSameTarget = 0.5;  // [m]
constexpr int kGivenUp = 2;          // drives to one place

/// A view that is worth a drive.
struct RankedView {
  planning::View view;
  std::size_t height = 0;
};

bool HasFailed(const Eigen::Vector2d& p_map, std::span<const FailedTarget> failed) {
  return std::ranges::any_of(failed, [&](const FailedTarget& target) {
    return target.times >= kGivenUp && (target.p_map - p_map).norm() < kSameTarget;
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

}  // namespace

std::optional<PlannedDrive> PlanNextDrive(const Surroundings& around, const Pose2& T_map_base,
                                          std::span<const FailedTarget> failed,
                                          const MissionOptions& options, std::uint64_t seed) {
  const std::vector<RankedView> ranked = RankViews(around, T_map_base, failed, options, seed);
  const std::size_t count = std::min(ranked.size(), static_cast<std::size_t>(options.patience.targets));
  std::vector<Spaces> spaces;
  for (std::size_t h = 0; h < around.areas.size(); ++h)
    spaces.push_back(SpacesAt(around, h, options.planner.free_space));
  std::optional<PlannedDrive> drive;
  const auto try_all = [&](const auto& plan_drive) {
    for (std::size_t rank = 0; rank < count && !drive; ++rank) {
      const auto& [view, height] = ranked[rank];
      drive = plan_drive(spaces[height], Pose2{view.direction, view.p_map});
      if (drive) drive->view = view, drive->height = height, drive->rank = rank;
    }
  };
  TryWays(around, T_map_base, options, seed, try_all);
  return drive;
}

std::optional<PlannedDrive> PlanDriveTo(const Surroundings& around, const Pose2& T_map_base,
                                        const Pose2& T_map_goal, const MissionOptions& options,
                                        std::uint64_t seed) {
  const Spaces spaces = SpacesAt(around, 0, options.planner.free_space);
  std::optional<PlannedDrive> drive;
  TryWays(around, T_map_base, options, seed, [&](const auto& plan_drive) {
    if (!drive) drive = plan_drive(spaces, T_map_goal);
  });
  return drive;
}

}  // namespace ariadne::experiments
