#pragma once

#include <string>

#include "experiments/exploration/scan_loop_world.h"
#include "experiments/report/table.h"
#include "slam/geometry/drawing.h"

namespace ariadne::experiments {

/// One exploration with one planner, as the tables need it.
struct Nbv3dTrial {
  std::string world;
  std::string planner;
  int seed = 0;
  double scans = 0.0;
  double path = 0.0;          // [m]
  double target_scans = 0.0;  // to the target; infinite where it was not reached
  double target_path = 0.0;   // [m]
  double covered = 0.0;       // shares, at the end
  double mapped = 0.0;
  ScanLoopVerdict verdict;
  double ended = 0.0;  // 1: by itself
  double refused = 0.0;
  double collisions = 0.0;
  double planning_seconds = 0.0;  // of a decision, mean
  double matching_seconds = 0.0;  // of a scan, mean
};

Nbv3dTrial SummarizeTrial(const Exploration3d& exploration, const ScanLoopVerdict& verdict, double target);

/// Every trial in full precision, without its times.
Table Nbv3dTrialTable(const std::vector<Nbv3dTrial>& trials);

/// The steps of one exploration, without their times.
Table RobotStepTable(const Exploration3d& exploration);

/// From above: the walls as they are, the area with its seen and unseen edges, the way that was driven,
/// where the scans were taken and where they were thought to be taken.
slam::Drawing DrawExploration(const Exploration3d& exploration, const Floor& floor);

}  // namespace ariadne::experiments
