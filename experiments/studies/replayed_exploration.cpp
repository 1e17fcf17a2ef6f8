#include "experiments/studies/replayed_exploration.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include "drivers/replay/compared_robot.h"
#include "experiments/studies/explore_report.h"
#include "experiments/studies/recorded_decisions.h"
#include "experiments/studies/unlogged_end.h"

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

/// The run's log of the robot; an empty one where it did not come so far.
drivers::RobotLog RobotLogOf(const fs::path& run) {
  const fs::path path = run / "robot.log";
  if (fs::exists(path)) return drivers::ReadRobotLog(path);
  return {std::make_unique<std::istringstream>(), path.string()};
}

/// What a run says of its failure; empty where it did not fail.
std::string FailureOf(const fs::path& run) {
  std::ifstream in(run / "progress.json");
  const Json progress = Json::parse(in, nullptr, false);
  return progress.is_object() ? progress.value("error", "") : "";
}

/// A start under replay.
class ReplayedStart {
 public:
  ReplayedStart(const RecordedStart& start, const ExploreStudyOptions& options, ProgressDisplay& progress)
      : start_(start),
        options_(options),
        progress_(progress),
        lines_(start.log),
        person_(AnsweringAs(start.notes)),
        decisions_(start.run) {}

  ReplayResult Run();

 private:
  void RunRobot();
  void RunMissionOn(ExploredRobot& robot);
  MissionEvents Events(drivers::ComparedRobot& compared, UnloggedEnd& driven,
                       const drivers::ReplayRobot* before);
  void NoteFailure(const std::string& sentence);

  const RecordedStart& start_;
  const ExploreStudyOptions& options_;
  ProgressDisplay& progress_;
  drivers::RecordedLines lines_;
  AskedPerson person_;
  RecordedDecisions decisions_;
  MissionSteps steps_;
  bool rejected_ = false;
  ReplayResult result_;
};

/// As RunExplore has them, but for what is compared instead of kept.
MissionEvents ReplayedStart::Events(drivers::ComparedRobot& compared, UnloggedEnd& driven,
                                    const drivers::ReplayRobot* before) {
  MissionEvents events;
  const auto kept = [this, &compared] { return start_.last || compared.left() > 0; };
  events.on_status = [this](const std::string& status) { progress_.Show(status); };
  events.stop = driven.Latched([this] { return rejected_ || person_.MustStop(); });
  events.on_stop = [this, kept](const MissionStop& at, const MissionMap& map) {
    steps_.OnStop(at, map);
    if (kept()) decisions_.CompareStop(steps_.step());
    progress_.Keep(StopLine(result_.stops++, at));
  };
  events.on_plan = [this, kept, &compared](const PlannedDrive& drive, const Surroundings& around) {
    steps_.OnPlan(drive, around);
    if (kept()) decisions_.ComparePlan(steps_.step());
    compared.Note(NoteOf(drive));
  };
  if (!options_.approve) return events;
  events.approve = [this, before, stopped = events.stop](const PlannedDrive& drive) {
    if (before != nullptr && before->Replayed()) return true;
    rejected_ = !person_.Approves(drive);
    return !stopped();
  };
  return events;
}

/// A start that went on from another one hears that from the log of the robot, as it did then.
void ReplayedStart::RunMissionOn(ExploredRobot& robot) {
  drivers::RobotLog log = RobotLogOf(start_.run), earlier = RobotLogOf(start_.run);
  if (!start_.last) log.Truncate(start_.robot_records);
  earlier.Truncate(start_.notes.resumed_after);
  std::optional<drivers::ReplayRobot> before;
  if (start_.notes.resumed_after > 0) {
    before.emplace(earlier, drivers::LiveRobot{[&robot]() -> drivers::Robot& { return robot.robot(); }});
  }
  drivers::ComparedRobot compared(before ? *before : robot.robot(), log);
  UnloggedEnd driven(compared, robot.robot());
  const MissionEvents events = Events(compared, driven, before ? &*before : nullptr);
  try {
    const MissionResult mission =
        RunMission(driven, MissionOf(options_), static_cast<std::uint64_t>(options_.seed), events);
    result_.end = fmt::format("the mission ended as it did: {}", Describe(mission.end));
    if (start_.last) decisions_.CompareEnd(mission);
  } catch (...) {
    result_.robot_calls = compared.compared();
    throw;
  }
  result_.robot_calls = compared.compared();
}

/// The robot stops its wheels where it ends, which is on the lines too.
void ReplayedStart::RunRobot() {
  {
    const std::unique_ptr<ExploredRobot> robot =
        MakeReplayedRobot(options_.robot, options_.hardware, lines_, [this] { return person_.MustStop(); });
    RunMissionOn(*robot);
  }
  lines_.ExpectEnd();
}

/// Failures are answers too, and must be those that the run had.
void ReplayedStart::NoteFailure(const std::string& sentence) {
  if (sentence == lines_.departure()) return;
  const std::string recorded = FailureOf(start_.run);
  result_.end = fmt::format("it failed as it did: {}", sentence);
  if (!start_.last || sentence == recorded) return;
  result_.departure = fmt::format("the run {}; now it fails: {}",
                                  recorded.empty() ? "did not fail" : "failed: " + recorded, sentence);
}

ReplayResult ReplayedStart::Run() {
  try {
    RunRobot();
  } catch (const drivers::LinesEnded&) {
    result_.end = "the recording ends there";
  } catch (const drivers::DepartedFromLog& departed) {
    result_.departure = departed.what();
  } catch (const Error& error) {
    NoteFailure(error.what());
  }
  // Behind a departure of the mission the lines depart as well, since the wheels are told to stop.
  if (result_.departure.empty()) result_.departure = lines_.departure();
  result_.line_calls = lines_.repeated();
  result_.time = lines_.time();
  return result_;
}

/// lines.log, lines-2.log ... lines-10.log
bool IsEarlierLog(const fs::path& a, const fs::path& b) {
  const std::string one = a.filename(), other = b.filename();
  return one.size() != other.size() ? one.size() < other.size() : one < other;
}

}  // namespace

std::vector<RecordedStart> FindRecordedStarts(const fs::path& path) {
  const std::vector<fs::path> wanted = drivers::FindLineLogs(path);
  const fs::path run = fs::absolute(wanted.front()).parent_path();
  if (!fs::exists(run / "config.yaml")) {
    Fail(
        "{}: is no directory of a run of `ariadne explore`, as it has no config.yaml; a replay needs the "
        "whole directory",
        run.string());
  }
  std::vector<fs::path> logs = drivers::FindLineLogs(run);
  std::ranges::sort(logs, IsEarlierLog);
  std::vector<RecordedStart> starts;
  for (const fs::path& log : logs) {
    const RunNotes notes = ReadRunNotes(log);
    if (notes.resumed_after > 0 && !starts.empty()) {
      starts.back().last = false;
      starts.back().robot_records = notes.resumed_after;
    }
    starts.push_back({run, log, notes});
  }
  std::erase_if(starts, [&wanted](const RecordedStart& start) {
    return std::ranges::none_of(wanted,
                                [&start](const fs::path& log) { return fs::absolute(log) == start.log; });
  });
  return starts;
}

ReplayResult ReplayExploration(const RecordedStart& start, const ExploreStudyOptions& options,
                               ProgressDisplay& progress) {
  return ReplayedStart(start, options, progress).Run();
}

}  // namespace ariadne::experiments
