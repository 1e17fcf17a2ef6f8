#pragma once

#include <string>
#include <vector>

#include "experiments/mission/mission_world.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/report/table.h"
#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// One mission in one world, as the tables need it.
struct MissionTrial {
  std::string world;
  std::string way;  // what was done otherwise
  int seed = 0;
  MissionEnd end = MissionEnd::kNothingLeft;
  double scans = 0.0;
  double path = 0.0;          // [m]
  double minutes = 0.0;       // of the robot's clock
  double target_scans = 0.0;  // to the target; infinite where it was not reached
  double target_path = 0.0;   // [m]
  double covered = 0.0;       // shares, at the end
  double mapped = 0.0;
  MissionVerdict verdict;
  double ended = 0.0;  // 1: by itself, for nothing was left
  double refused = 0.0;
  double blocked = 0.0;  // drives that were given up
  double collisions = 0.0;
  double planning_seconds = 0.0;  // of a decision, mean
  double matching_seconds = 0.0;  // of a scan, mean
};

MissionTrial SummarizeMission(const SimulatedMission& mission, const MissionVerdict& verdict,
                              double target);

/// Every trial in full precision, without its times.
Table MissionTrialTable(const std::vector<MissionTrial>& trials);

/// The times, which are not deterministic.
Json MissionTrialTimes(const std::vector<MissionTrial>& trials);

}  // namespace ariadne::experiments
