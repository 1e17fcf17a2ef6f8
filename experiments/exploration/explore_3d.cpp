#include "experiments/exploration/explore_3d.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/exploration/robot_drive.h"
#include "slam/base/numbers.h"
#include "slam/base/stopwatch.h"

namespace ariadne::experiments {
namespace {

constexpr double kMapped = 0.1;     // between a wall and the edge that shows it [m]
constexpr double kPathStep = 0.05;  // of the path that is kept for drawings [m]

/// Which places of the cover have been seen.
class SeenCover {
 public:
  explicit SeenCover(const FloorToExplore& floor) : floor_(floor), seen_(floor.cover.places_map.size()) {}

  double Add(const slam::Pose2& T_map_scan, const FloorScannerOptions& scanner) {
    for (const std::uint32_t k :
         SeenPlaces(ViewFloor(floor_.floor, T_map_scan, scanner), floor_.cover, scanner))
      seen_[k] = true;
    return static_cast<double>(std::ranges::count(seen_, true)) / static_cast<double>(seen_.size());
  }

 private:
  const FloorToExplore& floor_;
  std::vector<bool> seen_;
};

double MappedShare(const FloorCover& cover, std::span<const planning::LabelledPolygon> area) {
  const auto mapped = std::ranges::count_if(
      cover.places_map, [&](const Eigen::Vector2d& p) { return DistanceToEdges(p, area, true) < kMapped; });
  return static_cast<double>(mapped) / static_cast<double>(cover.places_map.size());
}

/// What is to be done next.
struct NextDrive {
  std::optional<planning::View> view;
  std::vector<Eigen::Vector2d> path_map;
  double heading = 0.0;  // at its end
};

/// The first part of a way; then the robot looks to where it goes on.
void CutToLeg(double max_leg, NextDrive& next) {
  next.heading = next.view->direction;
  double rest = max_leg;
  for (std::size_t i = 0; i + 1 < next.path_map.size(); ++i) {
    const Eigen::Vector2d step = next.path_map[i + 1] - next.path_map[i];
    if (step.norm() <= rest) {
      rest -= step.norm();
      continue;
    }
    next.path_map[i + 1] = next.path_map[i] + rest * step.normalized();
    next.path_map.resize(i + 2);
    next.heading = std::atan2(step.y(), step.x());
    return;
  }
}

/// The exploring robot: what it has, and what it knows.
class RobotLoop {
 public:
  RobotLoop(std::shared_ptr<const drivers::RayScene> scene, const FloorToExplore& floor,
            const Explore3dOptions& options, std::uint64_t seed)
      : options_(options),
        floor_(floor),
        robot_(std::move(scene), options.robot, seed),
        mapper_(options.mapper),
        area_(options.area, ParseNumbers(options.heights, "heights"), robot_.T_base_laser()),
        cover_(floor),
        seed_(seed),
        T_map_odom_(robot_.T_map_base_true() * robot_.State().odometry.T_odom_base.Inverse()) {
    result_.path_map_true.push_back(robot_.T_map_base_true().translation);
  }

  /// Takes a scan and adds it to the map.
  void Scan(RobotScanStep& step);
  NextDrive Plan(RobotScanStep& step) const;
  void Drive(const NextDrive& next, RobotScanStep& step);

  Exploration3d& result() { return result_; }
  void Finish();

 private:
  std::vector<slam::Pose3> Poses() const;
  slam::Pose2 T_map_base() const { return FromAbove(Poses().back() * robot_.T_base_laser().Inverse()); }
  void NotePath(RobotScanStep& step);

  const Explore3dOptions& options_;
  const FloorToExplore& floor_;
  drivers::SimulatedRobot robot_;
  slam::Mapper mapper_;
  ScanLoopArea area_;
  SeenCover cover_;
  std::uint64_t seed_;
  slam::Pose2 T_map_odom_;  // at the start
  std::size_t path_noted_ = 0;
  Exploration3d result_;
};

std::vector<slam::Pose3> RobotLoop::Poses() const {
  std::vector<slam::Pose3> poses;
  for (const slam::MapScan& scan : mapper_.scans()) poses.push_back(scan.T_map_laser);
  return poses;
}

void RobotLoop::Scan(RobotScanStep& step) {
  const slam::Scan scan = robot_.TakeScan();
  slam::PosedCloud cloud{fmt::format("scan{:03}", result_.scans.size()), slam::ToPointCloud(scan),
                         slam::ToPose3(T_map_odom_ * scan.odometry.T_odom_base) * robot_.T_base_laser()};
  const Stopwatch watch;
  const slam::MatchResult match = mapper_.AddScan(cloud);
  step.matching_seconds = watch.Seconds();
  step.registered = match.registered;
  result_.refused += step.registered ? 0 : 1;
  cloud.T_map_laser = mapper_.scans().back().T_map_laser;
  area_.AddScan(cloud);
  result_.scans.push_back(std::move(cloud));
  result_.T_map_laser_true.push_back(slam::ToPose3(robot_.T_map_base_true()) * robot_.T_base_laser());
  step.T_map_base_true = robot_.T_map_base_true();
  step.T_map_base = T_map_base();
  step.T_map_base_guess = FromAbove(match.T_map_laser_guess * robot_.T_base_laser().Inverse());
  step.covered = cover_.Add(FromAbove(result_.T_map_laser_true.back()), options_.scanner);
}

/// Of the heights' plans the one with the highest value, of equal ones the first.
NextDrive RobotLoop::Plan(RobotScanStep& step) const {
  const Stopwatch watch;
  NextDrive next;
  const std::vector<slam::Pose3> poses = Poses();
  std::vector<slam::Pose2> T_map_scans;
  for (const slam::Pose3& T_map_laser : poses) T_map_scans.push_back(FromAbove(T_map_laser));
  for (std::size_t h = 0; h < area_.height_count(); ++h) {
    const std::vector<planning::LabelledPolygon> area = area_.At(h, poses);
    if (h == 0) step.mapped = MappedShare(floor_.cover, area);
    planning::ViewPlan plan =
        planning::PlanNextView(area, step.T_map_base, options_.planner, seed_ + poses.size(), T_map_scans);
    if (!plan.chosen) continue;
    const planning::View& view = plan.views[*plan.chosen];
    if (next.view && view.value <= next.view->value) continue;
    next = {view, std::move(plan.path_map), view.direction};
  }
  if (next.view) CutToLeg(options_.max_leg, next);
  step.planning_seconds = watch.Seconds();
  return next;
}

void RobotLoop::Drive(const NextDrive& next, RobotScanStep& step) {
  const slam::Pose2 T_map_odom = step.T_map_base * robot_.State().odometry.T_odom_base.Inverse();
  const DriveOutcome outcome = DriveWay(robot_, T_map_odom, next.path_map, next.heading);
  const double path = step.path;
  step = {};
  step.path = path;
  step.gain = next.view->gain;
  step.blocked = outcome.blocked;
  if (outcome.contact_map) area_.AddObstacle(*outcome.contact_map);
  NotePath(step);
}

void RobotLoop::NotePath(RobotScanStep& step) {
  const std::vector<drivers::TruePose>& path = robot_.path_true();
  for (; path_noted_ + 1 < path.size(); ++path_noted_) {
    const Eigen::Vector2d& to = path[path_noted_ + 1].T_map_base.translation;
    step.path += (to - path[path_noted_].T_map_base.translation).norm();
    if ((to - result_.path_map_true.back()).norm() > kPathStep) result_.path_map_true.push_back(to);
  }
}

void RobotLoop::Finish() {
  mapper_.Finish();
  const std::vector<slam::Pose3> poses = Poses();
  for (std::size_t i = 0; i < poses.size(); ++i) result_.scans[i].T_map_laser = poses[i];
  result_.area = area_.At(0, poses);
  result_.steps.back().mapped = MappedShare(floor_.cover, result_.area);
  result_.collisions = robot_.collisions();
}

/// The first step by which a share is covered.
const RobotScanStep* RobotStepOf(const Exploration3d& exploration, double share) {
  const auto found = std::ranges::find_if(exploration.steps,
                                          [&](const RobotScanStep& step) { return step.covered >= share; });
  return found == exploration.steps.end() ? nullptr : &*found;
}

}  // namespace

planning::ViewPlannerOptions RobotPlannerOptions() {
  planning::ViewPlannerOptions options;
  options.robot_radius = 0.35;
  options.free_space.resolution = 0.05;
  options.candidates.wall_clearance = 0.5;
  options.min_overlap = 0.2;
  return options;
}

drivers::SimulatedRobotOptions CoarseRobotOptions() {
  drivers::SimulatedRobotOptions options;
  options.ais.slices = 128;
  return options;
}

slam::MapperOptions RobotMapperOptions() {
  slam::MapperOptions options;
  options.registration.method = slam::MatchMethod::kGraph;
  options.icp.one_sided = true;
  options.icp.guess_share = 0.001;
  options.registration.graph.odometry_position = 0.02;
  options.registration.graph.odometry_angle = 0.01;
  options.registration.graph.floor_height = 0.01;
  options.registration.graph.floor_tilt = 0.005;
  return options;
}

Exploration3d Explore3d(std::shared_ptr<const drivers::RayScene> scene, const FloorToExplore& floor,
                        const Explore3dOptions& options, std::uint64_t seed,
                        const ExploreCallback& on_step) {
  CheckOptions(options, "explore.");
  RobotLoop loop(std::move(scene), floor, options, seed);
  std::vector<RobotScanStep>& steps = loop.result().steps;
  RobotScanStep step;
  int blocked = 0;
  for (;;) {
    loop.Scan(step);
    const NextDrive next = loop.Plan(step);
    steps.push_back(step);
    if (on_step) on_step(step);
    blocked = step.blocked ? blocked + 1 : 0;
    loop.result().ended = !next.view;
    if (!next.view || steps.size() >= static_cast<std::size_t>(options.max_scans) ||
        blocked >= options.max_blocked) {
      break;
    }
    loop.Drive(next, step);
  }
  loop.Finish();
  return std::move(loop.result());
}

double ScansTo(const Exploration3d& exploration, double share) {
  const RobotScanStep* step = RobotStepOf(exploration, share);
  return step == nullptr ? std::numeric_limits<double>::infinity()
                         : static_cast<double>(step - exploration.steps.data() + 1);
}

double PathTo(const Exploration3d& exploration, double share) {
  const RobotScanStep* step = RobotStepOf(exploration, share);
  return step == nullptr ? std::numeric_limits<double>::infinity() : step->path;
}

}  // namespace ariadne::experiments
