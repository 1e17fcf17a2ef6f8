#include "experiments/studies/explore.h"

#include <fmt/format.h>

#include <memory>

#include "drivers/replay/recording_robot.h"
#include "drivers/replay/replay_robot.h"
#include "drivers/simulated/ais_scanner.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/explore_model.h"
#include "experiments/studies/explore_pictures.h"
#include "experiments/studies/explore_report.h"
#include "experiments/studies/run_notes.h"
#include "experiments/studies/unlogged_end.h"
#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/uos_pose.h"

namespace ariadne::experiments {
namespace {

drivers::World LoadExploreWorld(const ExploreStudyOptions& options) {
  return drivers::LoadWorld(ExpandDataPath(options.world).string(), options.geometry);
}

/// A robot whose every answer is on the run's log before the mission gets it; a run that is resumed first
/// hears what the log has.
class LoggedExploration {
 public:
  LoggedExploration(ExploredRobot& robot, const std::filesystem::path& path) {
    auto seam = drivers::Seam::kNone;
    if (std::filesystem::exists(path)) {
      old_ = std::make_unique<drivers::RobotLog>(drivers::ReadRobotLog(path));
      seam = robot.Resume(*old_);
    }
    log_ = std::make_unique<drivers::RobotLogWriter>(path);
    if (old_) {
      auto replay = std::make_unique<drivers::ReplayRobot>(
          *old_,
          drivers::LiveRobot{[&robot]() -> drivers::Robot& { return robot.robot(); }, seam, log_.get()});
      replay_ = replay.get();
      robot_ = std::move(replay);
    } else {
      robot_ = std::make_unique<drivers::RecordingRobot>(robot.robot(), *log_);
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
    robot.Note(NoteOf(drive));
  };
  return events;
}

/// What is the same of all explorations.
struct ExploreRun {
  const ExploreStudyOptions& options;
  const RunDirectory& run;
  ProgressDisplay& progress;
  AskedPerson& person;

  std::uint64_t seed() const { return static_cast<std::uint64_t>(options.seed); }
  ExploringRobotOptions robot() const {
    ExploringRobotOptions robot = options.robot;
    robot.threads = options.threads;
    return robot;
  }
};

/// What a person decides goes into the log of a robot's lines, as long as there is this robot.
class NotesOfPerson {
 public:
  NotesOfPerson(AskedPerson& person, ExploredRobot& robot) : person_(person) {
    person_.NoteTo([&robot](const std::string& text) { robot.Note(text); });
  }
  ~NotesOfPerson() { person_.NoteTo({}); }
  NotesOfPerson(const NotesOfPerson&) = delete;
  NotesOfPerson& operator=(const NotesOfPerson&) = delete;

 private:
  AskedPerson& person_;
};

/// Those of a mission that is driven: who refuses a drive ends the mission, and how it ends is not on the
/// log. What the log has was approved before.
MissionEvents DrivenEventsOf(const ExploreRun& exploration, LoggedExploration& logged, UnloggedEnd& driven,
                             StepKeeper& steps) {
  const auto rejected = std::make_shared<bool>(false);
  AskedPerson& person = exploration.person;
  const std::function<bool()> stopped =
      driven.Latched([rejected, &person] { return *rejected || person.MustStop(); });
  MissionEvents events = EventsOf(exploration.run, exploration.progress, logged.robot(), steps, stopped);
  if (!person.approves_plans()) return events;
  events.approve = [rejected, stopped, &logged, &person](const PlannedDrive& drive) {
    if (logged.IsReplayed()) return true;
    *rejected = !person.Approves(drive);
    return !stopped();
  };
  return events;
}

/// ", ETA 60 s", as if views took as long as so far.
std::string EtaAfter(std::size_t stops, const MissionStop& at, const ProgressDisplay& display) {
  const auto done = static_cast<double>(stops);
  return ", " + display.Eta(done / (done + at.views_left));
}

/// In a world that is known to who looks on, who judges it.
SimulatedMission ExploreWorld(const ExploreRun& exploration, const MissionWorld& world) {
  const auto& [options, run, progress, person] = exploration;
  const std::unique_ptr<ExploredRobot> robot = MakeExploredRobot(
      exploration.robot(), options.hardware, options.emulated, world.scene, exploration.seed(), &run);
  const NotesOfPerson notes(person, *robot);
  LoggedExploration logged(*robot, run.File("robot.log"));
  UnloggedEnd driven(logged.robot(), robot->robot());
  StepKeeper steps(run);
  std::size_t stops = 0;
  ProgressDisplay& display = progress;
  const auto on_true_stop = [&stops, &display](const MissionStop& at, const TrueStop& truth) {
    const std::string eta = EtaAfter(++stops, at, display);
    display.Keep(StopLine(stops - 1, at, &truth) + eta);
  };
  SimulatedMission mission =
      RunSimulatedMission({*robot->truth(), drivers::AisMounting(options.robot.ais).T_base_laser}, driven,
                          world.floor, options.scanner, MissionOf(exploration.options), exploration.seed(),
                          DrivenEventsOf(exploration, logged, driven, steps), on_true_stop);
  if (mission.mission.end != MissionEnd::kStopped) steps.OnEnd(mission.mission);
  return mission;
}

/// In a building that nobody knows.
SimulatedMission ExploreForReal(const ExploreRun& exploration) {
  const auto& [options, run, progress, person] = exploration;
  AskedPerson& asked = person;
  const std::unique_ptr<ExploredRobot> robot =
      MakeExploredRobot(exploration.robot(), options.hardware, options.emulated, nullptr,
                        exploration.seed(), &run, [&asked] { return asked.MustStop(); });
  progress.Keep(fmt::format("connected; the motor board stops the wheels {} s after the last command",
                            options.hardware.motors.timeout));
  const NotesOfPerson notes(person, *robot);
  LoggedExploration logged(*robot, run.File("robot.log"));
  UnloggedEnd driven(logged.robot(), robot->robot());
  StepKeeper steps(run);
  MissionEvents events = DrivenEventsOf(exploration, logged, driven, steps);
  ProgressDisplay& display = progress;
  events.on_stop = [&display, keep = events.on_stop](const MissionStop& at, const MissionMap& map) {
    display.Keep(StopLine(map.size() - 1, at) + EtaAfter(map.size(), at, display));
    keep(at, map);
  };
  SimulatedMission mission;
  mission.mission = RunMission(driven, MissionOf(exploration.options), exploration.seed(), events);
  if (mission.mission.end != MissionEnd::kStopped) steps.OnEnd(mission.mission);
  return mission;
}

/// The end of a run: the model, and the page.
std::string FinishExploration(const ExploreRun& exploration, const SimulatedMission& mission,
                              const std::string& of, const std::string& text) {
  const auto& [options, run, progress, person] = exploration;
  const std::size_t stops = mission.mission.stops.size();
  const bool called_off = mission.mission.end == MissionEnd::kRejected && person.MustStop();
  if (mission.mission.end == MissionEnd::kStopped || called_off) {
    run.WriteProgress("stopped", stops, 0);
    return text + "stopped; --resume goes on from here\n";
  }
  BuildingModel model{slam::Octree(options.model.octree), {}, {}};
  if (options.integrate)
    model = WriteExploredModel(mission.mission, options.mission.mapper.scan, options.model, run, progress);
  FinishRun(run, fmt::format("Exploration of {}", of), stops, ExplorationView(mission, model));
  return text;
}

}  // namespace

MissionOptions MissionOf(const ExploreStudyOptions& options) {
  MissionOptions mission = options.mission;
  mission.mapper.icp.threads = options.threads;
  return mission;
}

void CheckExplore(const ExploreStudyOptions& options) {
  CheckOptions(options, "");
  if (options.robot.kind != RobotKind::kHardware) LoadExploreWorld(options);
}

std::string RunExplore(const ExploreStudyOptions& options, const RunDirectory& run,
                       ProgressDisplay& progress, const std::function<bool()>& stop,
                       const std::function<bool(const PlannedDrive&)>& approve) {
  WriteManifest(run, {});
  AskedPerson person(stop, approve);
  const ExploreRun exploration{options, run, progress, person};
  if (options.robot.kind == RobotKind::kHardware) {
    progress.Show("finding the devices");
    const SimulatedMission mission = ExploreForReal(exploration);
    return FinishExploration(exploration, mission, "a real building", ReportUnjudged(mission.mission, run));
  }
  progress.Show("what there is to see");
  const Parallel parallel(options.threads);
  const MissionWorld world = PrepareMissionWorld(LoadExploreWorld(options), options.robot, options.scanner,
                                                 options.judge, parallel);
  const SimulatedMission mission = ExploreWorld(exploration, world);
  progress.Show("the report");
  return FinishExploration(exploration, mission, world.scene->world().name,
                           ReportExploration(mission, world, run, parallel));
}

}  // namespace ariadne::experiments
