#pragma once

#include "drivers/simulated/load_world.h"
#include "experiments/field/preflight_options.h"
#include "experiments/mission/mission_world.h"
#include "experiments/mission/simulated_mission.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/explored_robot.h"
#include "experiments/studies/model_options.h"

namespace ariadne::experiments {

/// The experiment `explore`: a robot that was never told the building leaves a 3D model of it.
struct ExploreStudyOptions {
  std::string world = "builtin:robobench";
  int seed = 1;
  int threads = 2;
  ExploringRobotOptions robot{MissionRobotOptions()};
  drivers::HardwareRobotOptions hardware = MissionHardwareOptions();
  drivers::EmulatedRobotOptions emulated;
  PreflightOptions check;
  bool approve = false;
  MissionOptions mission;
  FloorScannerOptions scanner;
  MissionWorldOptions judge;
  bool integrate = true;
  ModelOptions model;
  drivers::WorldOptions geometry;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("world", self.world,
          "what is explored: builtin:robobench, builtin:entrance_hall, a floor plan (.json), a description "
          "(.yaml) or a mesh");
    visit("seed", self.seed, Unit(""), Range{0, 1e9},
          "of the errors of wheels and scanners, and of candidates");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "results do not depend on it");
    visit("robot", self.robot, "what explores: the simulated robot and its scanner, or another one");
    visit("hardware", self.hardware,
          "of robots of devices: their drivers, how scans are taken, the wheels");
    visit("emulated", self.emulated, "the emulated devices, on the simulated base of robot.base");
    visit("check", self.check, "what ariadne check asks of a robot on ports before it leaves");
    visit("approve", self.approve,
          "ask on the terminal before each drive, like --approve; any key, or a lost terminal, stops");
    visit("mission", self.mission, "the mission");
    visit("scanner", self.scanner, "what a scan can show of the walls, which counts as covered");
    visit("judge", self.judge, "what there is to see, against which the mission is judged");
    visit("integrate", self.integrate,
          "make a model of all scans in the end, and write it in all its forms");
    visit("model", self.model, "what that model is like");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
  }
};

/// The mission, with the threads of the study.
MissionOptions MissionOf(const ExploreStudyOptions& options);

/// Error where the world cannot be read.
void CheckExplore(const ExploreStudyOptions& options);

/// Explores, with every answer of the robot on robot.log and every scan in scans/ before the next step; a
/// run that was killed repeats its decisions from the log and goes on where it was. `stop` is asked before
/// each command of the robot, and `approve` before each drive that is not on the log already; false ends
/// the mission. Returns what to print.
std::string RunExplore(const ExploreStudyOptions& options, const RunDirectory& run,
                       ProgressDisplay& progress, const std::function<bool()>& stop = {},
                       const std::function<bool(const PlannedDrive&)>& approve = {});

}  // namespace ariadne::experiments
