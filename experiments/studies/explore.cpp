#include "experiments/studies/explore.h"

#include <fmt/format.h>

#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/explore_report.h"

namespace ariadne::experiments {
namespace {

drivers::World LoadExploreWorld(const ExploreStudyOptions& options) {
  return drivers::LoadWorld(ExpandDataPath(options.world).string(), options.geometry);
}

ScanLoopWorld PrepareExploreWorld(const ExploreStudyOptions& options) {
  Explore3dOptions sight;
  sight.scanner = options.scanner;
  sight.robot = options.robot;
  return PrepareScanLoopWorld(LoadExploreWorld(options), sight, options.judge, Parallel(options.threads));
}

}  // namespace

void CheckExplore(const ExploreStudyOptions& options) {
  CheckOptions(options, "");
  LoadExploreWorld(options);
}

std::string RunExplore(const ExploreStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress) {
  WriteManifest(run, {});
  progress.Show("what there is to see");
  const ScanLoopWorld world = PrepareExploreWorld(options);
  drivers::SimulatedRobotOptions robot_options = options.robot;
  robot_options.threads = options.threads;
  MissionOptions mission_options = options.mission;
  mission_options.mapper.icp.threads = options.threads;
  const auto seed = static_cast<std::uint64_t>(options.seed);
  drivers::SimulatedRobot robot(world.scene, robot_options, seed);
  MissionEvents events;
  events.on_status = [&](const std::string& status) { progress.Show(status); };
  std::size_t scans = 0;
  const auto on_true_stop = [&](const MissionStop& stop, const TrueStop& truth) {
    run.WriteProgress("running", ++scans, 0);
    progress.Keep(StopLine(scans - 1, stop, truth));
  };
  const SimulatedMission mission = RunSimulatedMission(robot, robot, world.floor, options.scanner,
                                                       mission_options, seed, events, on_true_stop);
  std::string text = ReportExploration(mission, world, run, Parallel(options.threads));
  FinishRun(run, fmt::format("Exploration of {}", world.scene->world().name), scans);
  return text;
}

}  // namespace ariadne::experiments
