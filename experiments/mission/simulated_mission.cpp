#include "experiments/mission/simulated_mission.h"

#include <algorithm>
#include <limits>

namespace ariadne::experiments {
namespace {

constexpr double kMappedWithin = 0.1;  // between a wall and the edge that shows it [m]
constexpr double kTruePathStep = 0.05;

/// The watcher. What it notes is of the time of each stop: a robot whose mission is replayed from a log has
/// been brought to the end of that already.
class Watcher {
 public:
  Watcher(const TrueRobot& robot, const FloorToExplore& floor, const FloorScannerOptions& scanner)
      : robot_(robot), floor_(floor), scanner_(scanner), seen_(floor.cover.places_map.size()) {
    result_.path_world.push_back(robot.base.path_true().front().T_map_base.translation);
  }

  TrueStop Note(const MissionStop& stop, const MissionMap& map);
  SimulatedMission Finish(MissionResult mission);

 private:
  double CoveredFrom(const slam::Pose2& T_world_scan);
  double MappedShare(std::span<const planning::LabelledPolygon> area_map) const;
  void NotePath(double until);
  std::vector<drivers::Collision> CollisionsUntil(double time) const;

  const TrueRobot& robot_;
  const FloorToExplore& floor_;
  const FloorScannerOptions& scanner_;
  std::vector<bool> seen_;
  std::size_t path_noted_ = 0;
  double path_ = 0.0;
  SimulatedMission result_;
};

double Watcher::CoveredFrom(const slam::Pose2& T_world_scan) {
  for (const std::uint32_t k :
       SeenPlaces(ViewFloor(floor_.floor, T_world_scan, scanner_), floor_.cover, scanner_))
    seen_[k] = true;
  return static_cast<double>(std::ranges::count(seen_, true)) / static_cast<double>(seen_.size());
}

double Watcher::MappedShare(std::span<const planning::LabelledPolygon> area_map) const {
  const slam::Pose2 T_map_world = result_.T_world_map.Inverse();
  const auto mapped = std::ranges::count_if(floor_.cover.places_map, [&](const Eigen::Vector2d& p_world) {
    return DistanceToEdges(T_map_world * p_world, area_map, true) < kMappedWithin;
  });
  return static_cast<double>(mapped) / static_cast<double>(floor_.cover.places_map.size());
}

/// Goes on along the path to where the robot was at a time [s].
void Watcher::NotePath(double until) {
  const std::vector<drivers::TruePose>& path = robot_.base.path_true();
  for (; path_noted_ + 1 < path.size() && path[path_noted_ + 1].time <= until; ++path_noted_) {
    const Eigen::Vector2d& to = path[path_noted_ + 1].T_map_base.translation;
    path_ += (to - path[path_noted_].T_map_base.translation).norm();
    if ((to - result_.path_world.back()).norm() > kTruePathStep) result_.path_world.push_back(to);
  }
}

std::vector<drivers::Collision> Watcher::CollisionsUntil(double time) const {
  std::vector<drivers::Collision> collisions = robot_.base.collisions();
  std::erase_if(collisions, [time](const drivers::Collision& collision) { return collision.time > time; });
  return collisions;
}

TrueStop Watcher::Note(const MissionStop& stop, const MissionMap& map) {
  TrueStop truth;
  NotePath(stop.time);
  truth.T_world_base = robot_.base.path_true()[path_noted_].T_map_base;
  if (result_.truth.empty()) result_.T_world_map = truth.T_world_base * stop.T_map_base.Inverse();
  result_.T_world_laser.push_back(slam::ToPose3(truth.T_world_base) * robot_.T_base_laser);
  truth.path = path_;
  truth.covered = CoveredFrom(FromAbove(result_.T_world_laser.back()));
  truth.mapped = MappedShare(map.Area(0));
  truth.collisions = static_cast<int>(CollisionsUntil(stop.time).size());
  result_.truth.push_back(truth);
  return truth;
}

SimulatedMission Watcher::Finish(MissionResult mission) {
  result_.mission = std::move(mission);
  NotePath(result_.mission.time);
  result_.truth.back().mapped = MappedShare(result_.mission.area);
  result_.collisions = CollisionsUntil(result_.mission.time);
  return std::move(result_);
}

/// The first stop by which a share is covered.
std::optional<std::size_t> StopAt(const SimulatedMission& mission, double share) {
  const auto found =
      std::ranges::find_if(mission.truth, [&](const TrueStop& stop) { return stop.covered >= share; });
  if (found == mission.truth.end()) return {};
  return static_cast<std::size_t>(found - mission.truth.begin());
}

}  // namespace

drivers::SimulatedRobotOptions MissionRobotOptions() {
  drivers::SimulatedRobotOptions options;
  options.ais.slices = 256;
  options.base.command_timeout = 0.25;
  return options;
}

SimulatedMission RunSimulatedMission(const drivers::SimulatedRobot& truth, drivers::Robot& robot,
                                     const FloorToExplore& floor, const FloorScannerOptions& scanner,
                                     const MissionOptions& options, std::uint64_t seed,
                                     const MissionEvents& events, const TrueStopCallback& on_true_stop) {
  return RunSimulatedMission(TrueRobot{truth.base(), truth.T_base_laser()}, robot, floor, scanner, options,
                             seed, events, on_true_stop);
}

SimulatedMission RunSimulatedMission(const TrueRobot& truth, drivers::Robot& robot,
                                     const FloorToExplore& floor, const FloorScannerOptions& scanner,
                                     const MissionOptions& options, std::uint64_t seed,
                                     const MissionEvents& events, const TrueStopCallback& on_true_stop) {
  Watcher watcher(truth, floor, scanner);
  MissionEvents watched = events;
  watched.on_stop = [&](const MissionStop& stop, const MissionMap& map) {
    const TrueStop noted = watcher.Note(stop, map);
    if (on_true_stop) on_true_stop(stop, noted);
    if (events.on_stop) events.on_stop(stop, map);
  };
  return watcher.Finish(RunMission(robot, options, seed, watched));
}

double StopsTo(const SimulatedMission& mission, double share) {
  const auto stop = StopAt(mission, share);
  return stop ? static_cast<double>(*stop + 1) : std::numeric_limits<double>::infinity();
}

double WayTo(const SimulatedMission& mission, double share) {
  const auto stop = StopAt(mission, share);
  return stop ? mission.truth[*stop].path : std::numeric_limits<double>::infinity();
}

}  // namespace ariadne::experiments
