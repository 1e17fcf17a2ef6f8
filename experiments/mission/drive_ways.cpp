#include "experiments/mission/drive_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/mission/clear_way.h"
#include "experiments/mission/way_back.h"
#include "planning/path/geodesic.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kTurning = 0.6;         // half the diagonal, and a margin [m]
constexpr double kBackToRoom = 3.0;      // [m]
constexpr double kFarBack = 10.0;        // out of where there is no path [m]
constexpr double kFirstTry = 0.5;        // on the way there; each is twice as far back as the last one [m]
constexpr double kBesideApproach = 3.0;  // of the straight way; trajectories swing out [m]
constexpr double kStep = 0.05;           // between the poses of a disc's path [m]

planning::FreeSpace FreeSpaceAt(const Surroundings& around, std::size_t height,
                                const planning::FreeSpaceOptions& options,
                                std::span<const Eigen::Vector2d> obstacles_map) {
  std::vector<slam::Polygon2> plain;
  for (const planning::LabelledPolygon& polygon : around.areas[height])
    plain.push_back(planning::ToPolygon2(polygon));
  return planning::FreeSpace(plain, options, obstacles_map);
}

/// Of the footprint's margin: with all of it if the robot can, else with less, for beside a table it stands
/// closer than it likes to drive. A quarter is less than the localization errs.
constexpr std::array<double, 2> kMarginShares{1.0, 0.5};

/// Poses to a goal, of which the first ones are back the way that the robot came; none: no path was found.
struct FoundPath {
  std::vector<Pose2> poses;
  std::size_t retraced = 0;
};

/// From where the robot stands back the way that it came, to where there is room for its rectangle; only
/// where it stands, if there is room or none on the way.
std::vector<Pose2> WayToRoom(const planning::FreeSpace& space, const Pose2& T_map_base,
                             std::span<const Pose2> trail_map, const planning::FootprintOptions& options) {
  const planning::Footprint footprint(options);
  if (footprint.IsFree(space, T_map_base)) return {T_map_base};
  std::vector<Pose2> way = WayBack(trail_map, kBackToRoom);
  const auto room =
      std::ranges::find_if(way, [&](const Pose2& pose) { return footprint.IsFree(space, pose); });
  if (room == way.end()) return {T_map_base};
  way.erase(room + 1, way.end());
  return way;
}

/// Back, and from there on by a path with as much room as there is.
FoundPath PathFrom(std::vector<Pose2> way_back, const planning::FreeSpace& space, const Pose2& T_map_goal,
                   const planning::PathOptions& options, const RoomOptions& room, std::uint64_t seed) {
  const planning::PathResult path = planning::PlanPath(space, way_back.back(), T_map_goal, options, seed);
  if (path.status != planning::PathStatus::kFound) return {};
  const std::vector<Pose2> roomy = WithRoom(space, path.poses, options, room, seed);
  FoundPath found{std::move(way_back), 0};
  if (found.poses.size() > 1) found.retraced = found.poses.size();
  found.poses.insert(found.poses.end(), roomy.begin(), roomy.end());
  return found;
}

/// Back the way that the robot came, as far as it takes until there is a path: it may have got in where its
/// map shows too little room now.
FoundPath PathByTrail(const planning::FreeSpace& space, std::span<const Pose2> trail_map,
                      const Pose2& T_map_goal, const planning::PathOptions& options,
                      const RoomOptions& room, std::uint64_t seed) {
  const planning::Footprint robot(options.footprint);
  const planning::GeodesicField to_goal =
      planning::DistancesFrom(space, T_map_goal.translation, robot.least_radius());
  const std::vector<Pose2> way = WayBack(trail_map, kFarBack);
  double back = 0.0, next = kFirstTry;
  for (std::size_t i = 1; i < way.size(); ++i) {
    back += (way[i].translation - way[i - 1].translation).norm();
    if (back < next || !to_goal.IsReachable(space.CellOf(way[i].translation)) ||
        !robot.IsFree(space, way[i]))
      continue;
    next = 2.0 * back;
    FoundPath found = PathFrom({way.begin(), way.begin() + static_cast<std::ptrdiff_t>(i) + 1}, space,
                               T_map_goal, options, room, seed);
    if (!found.poses.empty()) return found;
  }
  return {};
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

/// Which paths will do.
struct PathRule {
  planning::PathOptions path;
  bool clear = false;     // all the way, or as far as it is worth a scan
  bool by_trail = false;  // first back the way that the robot came
};

std::optional<PlannedDrive> DriveByPath(const Spaces& spaces, const Surroundings& around,
                                        const Pose2& T_map_base, const Pose2& T_map_goal,
                                        const PathRule& rule, const MissionOptions& options,
                                        std::uint64_t seed) {
  const auto find = [&](const planning::FreeSpace& space) {
    return rule.by_trail ? PathByTrail(space, around.trail_map, T_map_goal, rule.path, options.room, seed)
                         : PathFrom(WayToRoom(space, T_map_base, around.trail_map, rule.path.footprint),
                                    space, T_map_goal, rule.path, options.room, seed);
  };
  FoundPath path = find(spaces.free);
  if (path.poses.empty()) return {};
  PlannedDrive drive;
  drive.margin = rule.path.footprint.margin;
  const std::size_t clear =
      rule.clear ? ClearPoses(path.poses, spaces.clear, rule.path.footprint) : path.poses.size();
  if (clear < path.poses.size()) {
    FoundPath detour = find(spaces.clear);
    drive.leg_only =
        detour.poses.empty() || LengthOf(detour.poses) > options.clear.detour * LengthOf(path.poses);
    if (drive.leg_only) path.poses.resize(clear);
    if (!drive.leg_only) path = std::move(detour);
    if (path.poses.empty() || (drive.leg_only && LengthOf(path.poses) < options.clear.min_leg)) return {};
  }
  drive.path_map = std::move(path.poses);
  drive.retraced = path.retraced;
  return drive;
}

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
  rules.push_back(rules.back());
  rules.back().by_trail = true;
  return rules;
}

}  // namespace

Spaces SpacesAt(const Surroundings& around, std::size_t height, const Pose2& T_map_base,
                const planning::FreeSpaceOptions& options) {
  std::vector<Eigen::Vector2d> doubtful_map = around.obstacles_map;
  for (const Eigen::Vector2d& p_map : around.unclear_map) {
    if ((p_map - T_map_base.translation).norm() > kTurning) doubtful_map.push_back(p_map);
  }
  return {FreeSpaceAt(around, height, options, around.obstacles_map),
          FreeSpaceAt(around, height, options, doubtful_map)};
}

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
}

std::vector<bool> MayHaveAPath(const Spaces& spaces, const Surroundings& around, const Pose2& T_map_base,
                               std::span<const Pose2> T_map_goals, const MissionOptions& options) {
  planning::FootprintOptions least = options.path.footprint;
  least.margin *= kMarginShares.back();
  const Pose2 start = WayToRoom(spaces.free, T_map_base, around.trail_map, least).back();
  return planning::ReachableGoals(spaces.free, start, T_map_goals, least);
}

std::optional<PlannedDrive> DriveOfDisc(const planning::FreeSpace& space, const Pose2& T_map_base,
                                        const Pose2& T_map_goal, const MissionOptions& options) {
  if (options.drive_by == DriveBy::kApproach) return {};
  const planning::GeodesicField ways =
      planning::DistancesFrom(space, T_map_base.translation, options.planner.robot_radius);
  const std::vector<Eigen::Vector2d> way_map = ways.PathTo(T_map_goal.translation);
  if (way_map.empty()) return {};
  PlannedDrive drive;
  drive.path_map = PosesAlong(way_map, T_map_base, T_map_goal.angle);
  drive.of_disc = true;
  CutToLeg(options.max_leg, drive);
  return drive;
}

}  // namespace ariadne::experiments
