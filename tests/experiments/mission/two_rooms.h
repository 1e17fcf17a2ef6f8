#pragma once

#include <memory>

#include "drivers/simulated/plan_world.h"
#include "experiments/mission/mission_world.h"
#include "experiments/mission/simulated_mission.h"

namespace ariadne::experiments {

/// Two rooms of 5 m x 5 m with an opening of 1.4 m between them; stubs of wall tell their ends apart.
inline drivers::World TwoRooms() {
  return drivers::ParsePlan(
      R"({"walls": [[0, 0, 10, 0], [10, 0, 10, 5], [10, 5, 0, 5], [0, 5, 0, 0], [5, 0, 5, 1.8],
                    [5, 3.2, 5, 5], [1.2, 5, 1.2, 4.2], [8.5, 0, 8.5, 0.9]],
          "doors": [], "start": [1.5, 2.5], "spaces": []})",
      "two rooms", {});
}

inline std::shared_ptr<const drivers::RayScene> TwoRoomsScene() {
  return std::make_shared<const drivers::RayScene>(TwoRooms());
}

/// Coarse scans, few candidates.
inline drivers::SimulatedRobotOptions QuickRobot() {
  drivers::SimulatedRobotOptions options = MissionRobotOptions();
  options.ais.slices = 64;
  return options;
}

inline MissionOptions QuickMission() {
  MissionOptions options;
  options.planner.candidates.count = 60;
  options.planner.refined = 40;
  options.area.polygon.slice.half_thickness = 0.1;
  options.limits.max_scans = 16;
  return options;
}

inline MissionWorld PrepareTwoRooms() {
  MissionWorldOptions options;
  options.reach_step = 0.2;
  return PrepareMissionWorld(TwoRooms(), QuickRobot(), {}, options, Parallel(1));
}

}  // namespace ariadne::experiments
