#include "experiments/mission/next_drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "experiments/mission/clear_way.h"
#include "planning/path/geodesic.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kSameTarget = 0.5;      // [m]
constexpr double kBackToRoom = 3.0;      // [m]
constexpr double kBesideApproach = 3.0;  // of the straight way; trajectories swing out [m]
constexpr int kGivenUp = 2;              // drives to one place
constexpr double kStep = 0.05;           // between the poses of a disc's path [m]

planning::FreeSpace FreeSpaceAt(const Surroundings& around, std::size_t height,
                                const planning::FreeSpaceOptions& options,
                                std::span<const Eigen::Vector2d> obstacles_map) {
  std::vector<slam::Polygon2> plain;
  for (const planning::LabelledPolygon& polygon : around.areas[height])
    plain.push_back(planning::ToPolygon2(polygon));
  return planning::FreeSpace(plain, options, obstacles_map);
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

/// Of the footprint's margin: with all of it if the robot can, else with less, for beside a table it stands
/// closer than it likes to drive. A quarter is less than the localization errs.
constexpr std::array<double, 2> kMarginShares{1.0, 0.5};

/// From where the robot stands back the way that it came, to where there is room for its rectangle; only
/// where it stands, if there is room or none on the way.
std::vector<Pose2> WayToRoom(const planning::FreeSpace& space, const Pose2& T_map_base,
                             std::span<const Pose2> trail_map, const planning::FootprintOptions& options) {
  const planning::Footprint footprint(options);
  std::vector<Pose2> way{T_map_base};
  if (footprint.IsFree(space, T_map_base)) return way;
  double length = 0.0;
  for (auto pose = trail_map.rbegin(); pose != trail_map.rend() && length < kBackToRoom; ++pose) {
    length += (pose->translation - way.back().translation).norm();
    way.push_back(*pose);
    if (footprint.IsFree(space, *pose)) return way;
  }
  return {T_map_base};
}

/// The poses of a path for the rectangle; empty where none was found.
std::vector<Pose2> FindPath(const planning::FreeSpace& space, const Pose2& T_map_base,
                            std::span<const Pose2> trail_map, const Pose2& T_map_goal,
                            const planning::PathOptions& options, std::uint64_t seed) {
  std::vector<Pose2> poses = WayToRoom(space, T_map_base, trail_map, options.footprint);
  const planning::PathResult path = planning::PlanPath(space, poses.back(), T_map_goal, options, seed);
  if (path.status != planning::PathStatus::kFound) return {};
  poses.insert(poses.end(), path.poses.begin(), path.poses.end());
  return poses;
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

/// What the paper tries (Sec. 5.2): the controller as it is, turning first, and turn, straight, turn.
std::optional<PlannedDrive> DriveByApproach(const Surroundings& around, const Pose2& T_map_base,
                                            const Pose2& T_map_goal, const MissionOptions& options) {
  control::GroundObstacles obstacles;
  const double reach = (T_map_goal.translation - T_map_base.translation).norm() + kBesideApproach;
  for (const Eigen::Vector2d& p_map : around.obstacles_map) {
    const bool stands_beside = control::GapTo(options.approach.robot, T_map_base, p_map) <= 0.0;
    if (!stands_beside && (p_map - T_map_base.translation).norm() < reach)
      obstacles.points.push_back(p_map);
  }
  const control::ApproachPlan plan =
      control::PlanApproach(T_map_base, T_map_goal, obstacles, options.approach);
  if (!plan.IsFree()) return {};
  PlannedDrive drive;
  drive.path_map = plan.poses;
  drive.margin = options.approach.robot.margin;
  drive.approach = ApproachTask{T_map_goal, plan.behaviour(), options.approach.approach};
  return drive;
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

/// The spaces of one height.
struct Spaces {
  planning::FreeSpace free;   // of all that is known to stand in the way
  planning::FreeSpace clear;  // and of what may
};

Spaces SpacesAt(const Surroundings& around, std::size_t height, const planning::FreeSpaceOptions& options) {
  std::vector<Eigen::Vector2d> doubtful_map = around.obstacles_map;
  doubtful_map.insert(doubtful_map.end(), around.unclear_map.begin(), around.unclear_map.end());
  return {FreeSpaceAt(around, height, options, around.obstacles_map),
          FreeSpaceAt(around, height, options, doubtful_map)};
}

/// Which paths will do.
struct PathRule {
  planning::PathOptions path;
  bool clear = false;  // all the way, or as far as it is worth a scan
};

std::optional<PlannedDrive> DriveByPath(const Spaces& spaces, const Surroundings& around,
                                        const Pose2& T_map_base, const Pose2& T_map_goal,
                                        const PathRule& rule, const MissionOptions& options,
                                        std::uint64_t seed) {
  const auto find = [&](const planning::FreeSpace& space) {
    return FindPath(space, T_map_base, around.trail_map, T_map_goal, rule.path, seed);
  };
  PlannedDrive drive;
  drive.path_map = find(spaces.free);
  if (drive.path_map.empty()) return {};
  drive.margin = rule.path.footprint.margin;
  const std::size_t clear =
      rule.clear ? ClearPoses(drive.path_map, spaces.clear, rule.path.footprint) : drive.path_map.size();
  if (clear == drive.path_map.size()) return drive;
  std::vector<Pose2> detour = find(spaces.clear);
  if (!detour.empty() && LengthOf(detour) <= options.clear.detour * LengthOf(drive.path_map)) {
    drive.path_map = std::move(detour);
    return drive;
  }
  drive.path_map.resize(clear);
  drive.leg_only = true;
  if (LengthOf(drive.path_map) < options.clear.min_leg) return {};
  return drive;
}

using PlanDrive = std::function<std::optional<PlannedDrive>(const Spaces& spaces, const Pose2& T_map_goal)>;

/// The best first.
std::vector<PathRule> PathRules(const MissionOptions& options) {
  std::vector<PathRule> rules;
  for (const bool clear : {true, false}) {
    if (clear && options.clear.gap <= 0.0) continue;
    for (const double share : kMarginShares) {
      rules.push_back({options.path, clear});
      rules.back().path.footprint.margin *= share;
    }
  }
  return rules;
}

/// Hands in the ways to get to a goal, the best first, until somebody has no need of more.
void TryWays(const Surroundings& around, const Pose2& T_map_base, const MissionOptions& options,
             std::uint64_t seed, const std::function<void(const PlanDrive&)>& attempt) {
  if (options.drive_by != DriveBy::kPath) {
    attempt([&](const Spaces&, const Pose2& T_map_goal) {
      return DriveByApproach(around, T_map_base, T_map_goal, options);
    });
  }
  if (options.drive_by == DriveBy::kApproach) return;
  for (const PathRule& rule : PathRules(options)) {
    attempt([&](const Spaces& spaces, const Pose2& T_map_goal) {
      std::optional<PlannedDrive> drive =
          DriveByPath(spaces, around, T_map_base, T_map_goal, rule, options, seed);
      if (drive) CutToLeg(options.max_leg, *drive);
      return drive;
    });
  }
  attempt([&](const Spaces& spaces, const Pose2& T_map_goal) {
    std::optional<PlannedDrive> drive = DriveOfDisc(spaces.free, T_map_base, T_map_goal, options);
    if (drive) CutToLeg(options.max_leg, *drive);
    return drive;
  });
}

}  // namespace

Surroundings SurroundingsOf(MissionMap& map, std::span<const Pose2> trail_map) {
  Surroundings around;
  for (std::size_t h = 0; h < map.height_count(); ++h) around.areas.push_back(map.Area(h));
  Ground ground = map.LookAtGround();
  around.obstacles_map = std::move(ground.obstacles_map);
  around.unclear_map = std::move(ground.unclear_map);
  around.T_map_scans = map.T_map_scans();
  around.trail_map.assign(trail_map.begin(), trail_map.end());
  return around;
}

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
