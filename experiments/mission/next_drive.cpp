#include "experiments/mission/next_drive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/path/geodesic.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kSameTarget = 0.5;  // [m]
constexpr double kCellReach = 0.03;  // of occupied cells beyond what occupies them [m]
constexpr int kGivenUp = 2;          // drives to one place
constexpr double kStep = 0.05;       // between the poses of a disc's path [m]

planning::FreeSpace FreeSpaceAt(const Surroundings& around, std::size_t height,
                                const planning::FreeSpaceOptions& options) {
  std::vector<slam::Polygon2> plain;
  for (const planning::LabelledPolygon& polygon : around.areas[height])
    plain.push_back(planning::ToPolygon2(polygon));
  return planning::FreeSpace(plain, options, around.obstacles_map);
}

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

/// With its full margin if it can, else with less: beside a table a robot stands closer than it likes to
/// drive, and cells reach a little beyond what occupies them.
planning::PathResult FindPath(const planning::FreeSpace& space, const Pose2& T_map_base,
                              const Pose2& T_map_goal, const planning::PathOptions& options,
                              std::uint64_t seed) {
  planning::PathResult result;
  for (const auto& [margin, shrunk] :
       {std::pair(1.0, 0.0), std::pair(0.4, 0.0), std::pair(0.0, kCellReach)}) {
    planning::PathOptions tighter = options;
    tighter.footprint.margin *= margin;
    tighter.footprint.length -= 2.0 * shrunk;
    tighter.footprint.width -= 2.0 * shrunk;
    result = planning::PlanPath(space, T_map_base, T_map_goal, tighter, seed);
    if (result.status == planning::PathStatus::kFound) break;
  }
  return result;
}

/// Poses along straight lines, the robot ahead; turns on the spot at the corners and the end.
std::vector<Pose2> PosesAlong(std::span<const Eigen::Vector2d> way_map, const Pose2& T_map_base,
                              double heading) {
  std::vector<Pose2> poses{T_map_base};
  for (std::size_t i = 0; i + 1 < way_map.size(); ++i) {
    const Eigen::Vector2d ahead = way_map[i + 1] - way_map[i];
    if (ahead.norm() < 1e-6) continue;
    const double angle = std::atan2(ahead.y(), ahead.x());
    const int pieces = std::max(1, static_cast<int>(std::ceil(ahead.norm() / kStep)));
    for (int k = 0; k <= pieces; ++k) poses.push_back({angle, way_map[i] + ahead * k / pieces});
  }
  poses.push_back({heading, poses.back().translation});
  return poses;
}

/// The first part of a path; at its end the robot looks to where it goes on.
void CutToLeg(double max_leg, PlannedDrive& drive) {
  double rest = max_leg;
  for (std::size_t i = 0; i + 1 < drive.path_map.size(); ++i) {
    rest -= (drive.path_map[i + 1].translation - drive.path_map[i].translation).norm();
    if (rest >= 0.0) continue;
    drive.path_map.resize(i + 1);
    drive.leg_only = true;
    return;
  }
}

std::optional<PlannedDrive> DriveOfDisc(const planning::FreeSpace& space, const Pose2& T_map_base,
                                        const Pose2& T_map_goal, const MissionOptions& options) {
  const planning::GeodesicField ways =
      planning::DistancesFrom(space, T_map_base.translation, options.planner.robot_radius);
  const std::vector<Eigen::Vector2d> way_map = ways.PathTo(T_map_goal.translation);
  if (way_map.empty()) return {};
  PlannedDrive drive;
  drive.path_map = PosesAlong(way_map, T_map_base, T_map_goal.angle);
  drive.of_disc = true;
  return drive;
}

}  // namespace

Surroundings SurroundingsOf(const MissionMap& map) {
  Surroundings around;
  for (std::size_t h = 0; h < map.height_count(); ++h) around.areas.push_back(map.Area(h));
  around.obstacles_map = map.Obstacles();
  around.T_map_scans = map.T_map_scans();
  return around;
}

std::optional<PlannedDrive> PlanNextDrive(const Surroundings& around, const Pose2& T_map_base,
                                          std::span<const FailedTarget> failed,
                                          const MissionOptions& options, std::uint64_t seed) {
  const std::vector<RankedView> ranked = RankViews(around, T_map_base, failed, options, seed);
  const std::size_t count = std::min(ranked.size(), static_cast<std::size_t>(options.patience.targets));
  std::optional<PlannedDrive> drive;
  for (std::size_t rank = 0; rank < count && !drive; ++rank) {
    const RankedView& target = ranked[rank];
    const planning::FreeSpace space = FreeSpaceAt(around, target.height, options.planner.free_space);
    const planning::PathResult path =
        FindPath(space, T_map_base, {target.view.direction, target.view.p_map}, options.path, seed);
    if (path.status == planning::PathStatus::kFound)
      drive = PlannedDrive{target.view, path.poses, target.height, rank};
  }
  for (std::size_t rank = 0; rank < count && !drive; ++rank) {
    const RankedView& target = ranked[rank];
    const planning::FreeSpace space = FreeSpaceAt(around, target.height, options.planner.free_space);
    drive = DriveOfDisc(space, T_map_base, {target.view.direction, target.view.p_map}, options);
    if (drive) drive->view = target.view, drive->height = target.height, drive->rank = rank;
  }
  if (drive) CutToLeg(options.max_leg, *drive);
  return drive;
}

std::optional<PlannedDrive> PlanDriveTo(const Surroundings& around, const Pose2& T_map_base,
                                        const Pose2& T_map_goal, const MissionOptions& options,
                                        std::uint64_t seed) {
  const planning::FreeSpace space = FreeSpaceAt(around, 0, options.planner.free_space);
  const planning::PathResult path = FindPath(space, T_map_base, T_map_goal, options.path, seed);
  std::optional<PlannedDrive> drive;
  if (path.status == planning::PathStatus::kFound) {
    drive = PlannedDrive{{}, path.poses};
  } else {
    drive = DriveOfDisc(space, T_map_base, T_map_goal, options);
  }
  if (drive) CutToLeg(options.max_leg, *drive);
  return drive;
}

}  // namespace ariadne::experiments
