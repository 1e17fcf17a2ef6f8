#pragma once

#include <string>

#include "experiments/mission/mission_world.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/report/page.h"
#include "experiments/report/table.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/model_output.h"
#include "slam/geometry/drawing.h"

namespace ariadne::experiments {

/// A line for the terminal about a stop; of the truth only where somebody knows it.
std::string StopLine(std::size_t index, const MissionStop& stop, const TrueStop* truth = nullptr);

/// The stops of a mission, without their times of computing.
Table StopTable(const SimulatedMission& mission);

/// Those of a mission in a building that nobody knows.
Table StopTable(const MissionResult& mission);

/// From above, in the world: the walls as they are, the area with its seen and unseen edges, the obstacles,
/// the way that was driven, where the scans were taken and where they were thought to be taken.
slam::Drawing DrawMission(const SimulatedMission& mission, const Floor& floor);

/// The interactive view of the points, the stops, the model and the way, in the map, and the pictures of
/// the steps.
PageSection ExplorationView(const SimulatedMission& mission, const BuildingModel& model);

/// Writes tables, trajectories and pictures; returns what to print.
std::string ReportExploration(const SimulatedMission& mission, const MissionWorld& world,
                              const RunDirectory& run, const Parallel& parallel);

/// The same of a mission that nobody can judge.
std::string ReportUnjudged(const MissionResult& result, const RunDirectory& run);

}  // namespace ariadne::experiments
