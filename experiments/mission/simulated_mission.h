#pragma once

#include "drivers/simulated/simulated_robot.h"
#include "experiments/exploration/floor_cover.h"
#include "experiments/mission/mission.h"

namespace ariadne::experiments {

/// Scans of 181 beams in 256 slices (Sec. 2.2), which take 3.4 s: with half of them, rows on the floor lie
/// 20 cm apart 3.3 m away, and more of it has no point nearby. The base stops by itself where commands fail
/// to come for a quarter of a second.
drivers::SimulatedRobotOptions MissionRobotOptions();

/// What is true of a stop, which the robot does not know.
struct TrueStop {
  slam::Pose2 T_world_base;
  double path = 0.0;     // truly driven up to here [m]
  double covered = 0.0;  // share of the walls that was visible from the true places of the scanner
  double mapped = 0.0;   // share of the walls with a seen edge of the area within 10 cm
  int collisions = 0;    // up to here
};

struct SimulatedMission {
  MissionResult mission;
  std::vector<TrueStop> truth;  // one per stop
  std::vector<slam::Pose3> T_world_laser;
  std::vector<Eigen::Vector2d> path_world;  // every 5 cm or so
  slam::Pose2 T_world_map;                  // by the first scan, which defines the map
  std::vector<drivers::Collision> collisions;
};

/// Called after each stop, before the mission's own on_stop.
using TrueStopCallback = std::function<void(const MissionStop&, const TrueStop&)>;

/// A mission with a simulated robot, and what a watcher who knows the world sees of it. Nothing of the
/// truth reaches the mission, which may talk to the robot through another one that records or replays.
SimulatedMission RunSimulatedMission(const drivers::SimulatedRobot& truth, drivers::Robot& robot,
                                     const FloorToExplore& floor, const FloorScannerOptions& scanner,
                                     const MissionOptions& options, std::uint64_t seed,
                                     const MissionEvents& events = {},
                                     const TrueStopCallback& on_true_stop = {});

/// What truly moves through the world, and where the 3D scanner truly sits on it.
struct TrueRobot {
  const drivers::SimulatedBase& base;
  slam::Pose3 T_base_laser;
};

/// The same with any robot whose base is simulated.
SimulatedMission RunSimulatedMission(const TrueRobot& truth, drivers::Robot& robot,
                                     const FloorToExplore& floor, const FloorScannerOptions& scanner,
                                     const MissionOptions& options, std::uint64_t seed,
                                     const MissionEvents& events = {},
                                     const TrueStopCallback& on_true_stop = {});

/// How many stops, or how much way [m], it took to see a share of the walls; infinite where it was not
/// reached.
double StopsTo(const SimulatedMission& mission, double share);
double WayTo(const SimulatedMission& mission, double share);

}  // namespace ariadne::experiments
