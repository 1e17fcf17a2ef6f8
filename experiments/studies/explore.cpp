#include "experiments/studies/explore.h"

#include <fmt/format.h>

#include <memory>

#include "drivers/replay/fast_forward.h"
#include "drivers/replay/recording_robot.h"
#include "drivers/replay/replay_robot.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/explore_model.h"
#include "experiments/studies/explore_pictures.h"
#include "experiments/studies/explore_report.h"
#include "experiments/studies/unlogged_end.h"
#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/uos_pose.h"

namespace ariadne::experiments {
namespace {

drivers::World LoadExploreWorld(const ExploreStudyOptions& options) {
  return drivers::LoadWorld(ExpandDataPath(options.world).string(), options.geometry);
}

/// The simulated robot, whose every answer is on the run's log before the mission gets it; a run that is
/// resumed first hears what the log has.
class LoggedSimulation {
 public:
  LoggedSimulation(drivers::SimulatedRobot& robot, const std::filesystem::path& path) {
    if (std::filesystem::exists(path)) {
      old_ = std::make_unique<drivers::RobotLog>(drivers::ReadRobotLog(path));
      drivers::FastForward(robot, *old_);
    }
    log_ = std::make_unique<drivers::RobotLogWriter>(path);
    if (old_) {
      auto replay = std::make_unique<drivers::ReplayRobot>(
          *old_, drivers::LiveRobot{[&robot]() -> drivers::Robot& { return robot; }, drivers::Seam::kNone,
                                    log_.get()});
      replay_ = replay.get();
      robot_ = std::move(replay);
    } else {
      robot_ = std::make_unique<drivers::RecordingRobot>(robot, *log_);
    }
  }
  drivers::LoggedRobot& robot() { return *robot_; }
  /// What is decided now was decided before, and has been done.
  bool IsReplayed() const { return replay_ != nullptr && replay_->Replayed(); }

 private:
  std::unique_ptr<drivers::RobotLog> old_;
  std::unique_ptr<drivers::RobotLogWriter> log_;
  std::unique_ptr<drivers::LoggedRobot> robot_;
  const drivers::ReplayRobot* replay_ = nullptr;
};

/// Each scan is a file of its own before the robot drives on.
void WriteExploredScan(const slam::PosedCloud& scan, const RunDirectory& run) {
  slam::WriteCloud(run.File("scans/" + scan.name + ".3d"), scan.cloud_laser);
  slam::WriteFileAtomically(run.File("scans/" + scan.name + ".pose"),
                            [&](std::ostream& out) { slam::WriteUosPose(out, scan.T_map_laser); });
}

/// What watches the mission and keeps what it does.
MissionEvents EventsOf(const RunDirectory& run, ProgressDisplay& progress, drivers::LoggedRobot& robot,
                       StepKeeper& steps, const std::function<bool()>& stop) {
  MissionEvents events;
  events.on_status = [&progress](const std::string& status) { progress.Show(status); };
  events.stop = stop;
  events.on_stop = [&run, &steps](const MissionStop& at, const MissionMap& map) {
    WriteExploredScan(map.LastScan(), run);
    steps.OnStop(at, map);
    run.WriteProgress("running", map.size(), 0);
  };
  events.on_plan = [&robot, &steps](const PlannedDrive& drive, const Surroundings& around) {
    steps.OnPlan(drive, around);
    if (drive.view) {
      robot.Note(fmt::format("drive to ({:.3f}, {:.3f}) m for {} rays", drive.view->p_map.x(),
                             drive.view->p_map.y(), drive.view->gain));
    } else {
      robot.Note("drive back");
    }
  };
  return events;
}

}  // namespace

void CheckExplore(const ExploreStudyOptions& options) {
  CheckOptions(options, "");
  LoadExploreWorld(options);
}

std::string RunExplore(const ExploreStudyOptions& options, const RunDirectory& run,
                       ProgressDisplay& progress, const std::function<bool()>& stop,
                       const std::function<bool(const PlannedDrive&)>& approve) {
  WriteManifest(run, {});
  progress.Show("what there is to see");
  const MissionWorld world = PrepareMissionWorld(LoadExploreWorld(options), options.robot, options.scanner,
                                                 options.judge, Parallel(options.threads));
  drivers::SimulatedRobotOptions robot_options = options.robot;
  robot_options.threads = options.threads;
  MissionOptions mission_options = options.mission;
  mission_options.mapper.icp.threads = options.threads;
  const auto seed = static_cast<std::uint64_t>(options.seed);
  drivers::SimulatedRobot robot(world.scene, robot_options, seed);
  LoggedSimulation logged(robot, run.File("robot.log"));
  UnloggedEnd driven(logged.robot(), robot);
  StepKeeper steps(run);
  std::size_t stops = 0;
  bool rejected = false;
  const auto stopped = driven.Latched([&] { return rejected || (stop && stop()); });
  MissionEvents events = EventsOf(run, progress, logged.robot(), steps, stopped);
  events.approve = [&](const PlannedDrive& drive) {
    if (!approve || logged.IsReplayed()) return true;
    rejected = !approve(drive);
    return !stopped();
  };
  const auto on_true_stop = [&](const MissionStop& at, const TrueStop& truth) {
    progress.Keep(StopLine(stops++, at, truth));
  };
  const SimulatedMission mission = RunSimulatedMission(robot, driven, world.floor, options.scanner,
                                                       mission_options, seed, events, on_true_stop);
  progress.Show("the report");
  std::string text = ReportExploration(mission, world, run, Parallel(options.threads));
  const bool called_off = mission.mission.end == MissionEnd::kRejected && stop && stop();
  if (mission.mission.end == MissionEnd::kStopped || called_off) {
    run.WriteProgress("stopped", stops, 0);
    return text + "stopped; --resume goes on from here\n";
  }
  steps.OnEnd(mission.mission);
  BuildingModel model{slam::Octree(options.model.octree), {}, {}};
  if (options.integrate)
    model = WriteExploredModel(mission.mission, options.mission.mapper.scan, options.model, run, progress);
  FinishRun(run, fmt::format("Exploration of {}", world.scene->world().name), stops,
            ExplorationView(mission, model));
  return text;
}

}  // namespace ariadne::experiments
