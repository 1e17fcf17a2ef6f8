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

/// A line for the terminal about a stop.
std::string StopLine(std::size_t index, const MissionStop& stop, const TrueStop& truth);

/// The stops of a mission, without their times.
Table StopTable(const SimulatedMission& mission);

/// From above, in the world: the walls as they are, the area with its seen and unseen edges, the obstacles,
/// the way that was driven, where the scans were taken and where they were thought to be taken.
slam::Drawing DrawMission(const SimulatedMission& mission, const Floor& floor);

/// The interactive view of the points, the stops, the model and the way, in the map, and the pictures of
/// the steps.
PageSection ExplorationView(const SimulatedMission& mission, const BuildingModel& model);

/// Writes tables, trajectories and pictures; returns what to print.
std::string ReportExploration(const SimulatedMission& mission, const MissionWorld& world,
                              const RunDirectory& run, const Parallel& parallel);

}  // namespace ariadne::experiments
