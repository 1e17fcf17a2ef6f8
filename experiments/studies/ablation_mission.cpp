#include "experiments/studies/ablation_mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>

#include "drivers/simulated/ais_scanner.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/explore_report.h"
#include "experiments/studies/mission_tables.h"
#include "slam/io/svg.h"

namespace ariadne::experiments {
namespace {

/// The name of a world without its folder, kind or what the plans' names end with.
std::string ShortWorldName(const std::string& world) {
  std::string name = std::filesystem::path(world.substr(world.find(':') + 1)).stem().string();
  const auto end = name.rfind("_updated");
  return end == std::string::npos ? name : name.substr(0, end);
}

drivers::World LoadMissionWorld(const std::string& name, const AblationMissionOptions& options) {
  return drivers::LoadWorld(ExpandDataPath(name).string(), options.geometry);
}

std::string MissionFileStem(const MissionTrial& trial) {
  std::string stem = fmt::format("missions/{}_{}_{}", trial.world, trial.way, trial.seed);
  std::ranges::replace(stem, ' ', '_');
  return stem;
}

/// The missions of a study, several at a time; what they leave does not depend on how many.
class MissionRuns {
 public:
  MissionRuns(const AblationMissionOptions& options, const RunDirectory& run, ProgressDisplay& progress,
              std::size_t total)
      : options_(options), run_(run), progress_(progress), total_(total), parallel_(options.threads) {}

  /// All ways and seeds in a world.
  void AddWorld(const std::string& name, const std::vector<MissionVariant>& ways);
  const std::vector<MissionTrial>& trials() const { return trials_; }

 private:
  MissionTrial RunOne(const MissionWorld& world, const MissionVariant& way, MissionTrial trial);
  void Say(const MissionTrial& trial, const std::string& what);
  /// On disk: who stops a study of hours keeps what has ended.
  void Keep(const MissionTrial& trial);

  const AblationMissionOptions& options_;
  const RunDirectory& run_;
  ProgressDisplay& progress_;
  std::size_t total_;
  Parallel parallel_;
  std::mutex display_;
  std::vector<MissionTrial> done_;  // as they ended
  std::vector<MissionTrial> trials_;
};

void MissionRuns::Say(const MissionTrial& trial, const std::string& what) {
  const std::lock_guard lock(display_);
  const double share = static_cast<double>(done_.size()) / static_cast<double>(total_);
  progress_.Show(fmt::format("{}, {}, seed {}: {}; {} of {} missions, {}", trial.world, trial.way,
                             trial.seed, what, done_.size(), total_, progress_.Eta(share)));
}

void MissionRuns::Keep(const MissionTrial& trial) {
  const std::lock_guard lock(display_);
  done_.push_back(trial);
  run_.WriteCsv("trials.csv", MissionTrialTable(done_));
  run_.WriteProgress("running", done_.size(), total_);
  progress_.Keep(fmt::format(
      "{}, {}, seed {}: {:.0f} scans, {:.0f} m, {} % of the walls, {} % of the surface, {:.1f} cm, {:.0f} "
      "contacts: {}",
      trial.world, trial.way, trial.seed, trial.scans, trial.path, Percent(trial.covered),
      Percent(trial.verdict.surface_covered), 100.0 * trial.verdict.translation_rms, trial.collisions,
      Describe(trial.end)));
}

MissionTrial MissionRuns::RunOne(const MissionWorld& world, const MissionVariant& way, MissionTrial trial) {
  const auto seed = static_cast<std::uint64_t>(trial.seed);
  const std::unique_ptr<ExploredRobot> robot =
      MakeExploredRobot(way.robot, MissionHardwareOptions(), {}, world.scene, seed, nullptr);
  int scans = 0;
  const auto on_stop = [&](const MissionStop&, const TrueStop& truth) {
    Say(trial,
        fmt::format("scan {}, {:.0f} m, {} % of the walls", ++scans, truth.path, Percent(truth.covered)));
  };
  const SimulatedMission mission =
      RunSimulatedMission({*robot->truth(), drivers::AisMounting(way.robot.ais).T_base_laser},
                          robot->robot(), world.floor, options_.scanner, way.mission, seed, {}, on_stop);
  MissionTrial summary = SummarizeMission(
      mission, JudgeMission(mission.mission.scans, mission.T_world_laser, world, Parallel(1)),
      options_.target);
  summary.world = trial.world;
  summary.way = trial.way;
  summary.seed = trial.seed;
  run_.WriteCsv(MissionFileStem(summary) + ".csv", StopTable(mission));
  slam::WriteSvg(run_.File(MissionFileStem(summary) + ".svg"), DrawMission(mission, world.floor.floor));
  Keep(summary);
  return summary;
}

void MissionRuns::AddWorld(const std::string& name, const std::vector<MissionVariant>& ways) {
  progress_.Show(ShortWorldName(name) + ": what there is to see");
  const MissionWorld world = PrepareMissionWorld(LoadMissionWorld(name, options_), options_.robot,
                                                 options_.scanner, options_.judge, parallel_);
  const auto seeds = static_cast<std::size_t>(options_.seeds);
  std::vector<MissionTrial> trials(ways.size() * seeds);
  parallel_.For(trials.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      trials[i].world = ShortWorldName(name);
      trials[i].way = ways[i / seeds].name;
      trials[i].seed = static_cast<int>(i % seeds) + 1;
      trials[i] = RunOne(world, ways[i / seeds], trials[i]);
    }
  });
  trials_.insert(trials_.end(), trials.begin(), trials.end());
  run_.WriteCsv("trials.csv", MissionTrialTable(trials_));
}

std::vector<MissionVariant> VariantsOf(const AblationMissionOptions& options) {
  std::vector<MissionVariant> ways = MissionVariants(options.mission, options.robot, options.variants);
  for (MissionVariant& way : ways) {
    way.robot.threads = 1;
    way.mission.mapper.icp.threads = 1;
  }
  return ways;
}

std::string ReportMissions(const AblationMissionOptions& options, const std::vector<MissionTrial>& trials,
                           const RunDirectory& run) {
  std::string text;
  const auto keep = [&](const std::string& name, const std::string& heading, const Table& table) {
    if (table.rows.empty()) return;
    run.WriteCsv(name + ".csv", table);
    run.WriteText(name + ".tex", ToLatex(table));
    text += heading + "\n" + ToText(table) + "\n";
  };
  keep("missions", "over all worlds (medians; refused, given up and collisions: means per mission)",
       MissionVariantTable(trials, options.target, options.bootstrap));
  keep("differences", "against the first way, in pairs (means with intervals)",
       MissionDifferenceTable(trials, options.mission.limits.max_scans, options.bootstrap));
  keep("worlds", "world by world (the same)", MissionWorldTable(trials, options.target));
  run.WriteJson("timing.json", MissionTrialTimes(trials));
  return text;
}

}  // namespace

void CheckAblationMission(const AblationMissionOptions& options) {
  CheckOptions(options);
  VariantsOf(options);
  if (ListedNames(options.worlds).empty()) Fail("worlds is empty: there is nothing to explore");
  for (const std::string& world : ListedNames(options.worlds)) LoadMissionWorld(world, options);
}

std::string RunAblationMission(const AblationMissionOptions& options, const RunDirectory& run,
                               ProgressDisplay& progress) {
  const std::vector<std::string> worlds = ListedNames(options.worlds);
  const std::vector<MissionVariant> ways = VariantsOf(options);
  const std::size_t total = worlds.size() * ways.size() * static_cast<std::size_t>(options.seeds);
  WriteManifest(run, {});
  MissionRuns runs(options, run, progress, total);
  for (const std::string& name : worlds) runs.AddWorld(name, ways);
  std::string text = ReportMissions(options, runs.trials(), run);
  FinishRun(run, "Whole missions, as configured and otherwise", total);
  return text;
}

}  // namespace ariadne::experiments
