#pragma once

#include "drivers/simulated/load_world.h"
#include "experiments/metrics/bootstrap.h"
#include "experiments/mission/mission_world.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/mission_ways.h"

namespace ariadne::experiments {

/// The experiment `ablation_mission`: whole missions in several buildings, as configured and otherwise.
struct AblationMissionOptions {
  std::string worlds = "builtin:robobench, builtin:entrance_hall";
  int seeds = 10;
  double target = 0.95;
  int threads = 2;
  MissionVariantOptions variants;
  drivers::SimulatedRobotOptions robot = MissionRobotOptions();
  MissionOptions mission;
  FloorScannerOptions scanner;
  MissionWorldOptions judge;
  drivers::WorldOptions geometry;
  BootstrapOptions bootstrap;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("worlds", self.worlds, "what is explored: a, b, ..., each as in the experiment `explore`");
    visit("seeds", self.seeds, Unit(""), Range{1, 1000},
          "missions in each world in each way; errors of wheels and scanners, and candidates");
    visit("target", self.target, Unit("share"), Range{0.0, 1.0},
          "of the walls, to which scans and way are counted");
    visit("threads", self.threads, Unit(""), Range{1, 1024},
          "missions at a time; results do not depend on it");
    visit("variants", self.variants, "what is done otherwise, one thing at a time");
    visit("robot", self.robot, "the simulated robot and its scanner");
    visit("mission", self.mission, "the mission that the others are compared with");
    visit("scanner", self.scanner, "what a scan can show of the walls, which counts as covered");
    visit("judge", self.judge, "what there is to see");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
    visit("bootstrap", self.bootstrap, "the confidence intervals");
  }
};

/// Error where a list cannot be read, or a world.
void CheckAblationMission(const AblationMissionOptions& options);

/// Returns what to print. Each mission leaves its stops and its drawing.
std::string RunAblationMission(const AblationMissionOptions& options, const RunDirectory& run,
                               ProgressDisplay& progress);

}  // namespace ariadne::experiments
