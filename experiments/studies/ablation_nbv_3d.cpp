#include "experiments/studies/ablation_nbv_3d.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "experiments/metrics/statistics.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/nbv_3d_trial.h"
#include "slam/base/numbers.h"
#include "slam/io/svg.h"

namespace ariadne::experiments {
namespace {

std::vector<std::string> ListedNames(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto first = part.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    names.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return names;
}

/// The name of a world without its folder, kind or what the plans' names end with.
std::string ShortWorldName(const std::string& world) {
  std::string name = std::filesystem::path(world.substr(world.find(':') + 1)).stem().string();
  const auto end = name.rfind("_updated");
  return end == std::string::npos ? name : name.substr(0, end);
}

/// What is compared.
struct Nbv3dWay {
  std::string name;
  Explore3dOptions explore;
};

/// The paper's choice among candidates, for a robot that must get there.
planning::ViewPlannerOptions PaperRobotPlanner(const planning::ViewPlannerOptions& robot) {
  planning::ViewPlannerOptions paper = planning::PaperViewPlannerOptions();
  paper.robot_radius = robot.robot_radius;
  paper.free_space = robot.free_space;
  paper.candidates = robot.candidates;
  return paper;
}

planning::ViewPlannerOptions Nbv3dPlanner(const std::string& name, planning::ViewPlannerOptions planner) {
  if (name == "default") return planner;
  if (name == "paper") return PaperRobotPlanner(planner);
  const auto& policies = EnumNames<planning::ViewPolicy>::value;
  const auto policy = std::ranges::find(policies, name);
  if (policy == policies.end()) Fail("planners: \"{}\" is neither default nor paper nor a policy", name);
  planner.policy = static_cast<planning::ViewPolicy>(policy - policies.begin());
  return planner;
}

std::vector<Nbv3dWay> Nbv3dWays(const AblationNbv3dOptions& options) {
  std::vector<Nbv3dWay> ways;
  for (const std::string& name : ListedNames(options.planners)) {
    ways.push_back({name, options.explore});
    ways.back().explore.planner = Nbv3dPlanner(name, options.explore.planner);
  }
  if (!ListedNames(options.overlaps).empty()) {
    for (const double overlap : ParseNumbers(options.overlaps, "overlaps")) {
      ways.push_back({fmt::format("overlap {}", overlap), options.explore});
      ways.back().explore.planner.min_overlap = overlap;
    }
  }
  for (std::string heights : ListedNames(options.slices)) {
    ways.push_back({"slices " + heights, options.explore});
    std::ranges::replace(heights, ' ', ',');
    ParseNumbers(heights, "slices");
    ways.back().explore.heights = heights;
  }
  if (ways.empty()) Fail("planners, overlaps and slices are empty: nothing to compare");
  return ways;
}

drivers::World LoadNbvWorld(const std::string& name, const AblationNbv3dOptions& options) {
  return drivers::LoadWorld(ExpandDataPath(name).string(), options.geometry);
}

using Nbv3dTrials = std::vector<Nbv3dTrial>;

std::vector<double> EachNbv3d(const Nbv3dTrials& trials,
                              const std::function<double(const Nbv3dTrial&)>& value) {
  std::vector<double> values;
  for (const Nbv3dTrial& trial : trials) values.push_back(value(trial));
  return values;
}

/// Nbv3dTrials that share a text, in the order of their first appearance.
std::vector<Nbv3dTrials> Nbv3dTrialsBy(std::string Nbv3dTrial::*text, const Nbv3dTrials& trials) {
  std::vector<Nbv3dTrials> groups;
  for (const Nbv3dTrial& trial : trials) {
    const auto group =
        std::ranges::find_if(groups, [&](const Nbv3dTrials& g) { return g.front().*text == trial.*text; });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(trial);
  }
  return groups;
}

std::string FiniteText(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string MedianWithInterval(const std::vector<double>& values, int digits,
                               const BootstrapOptions& bootstrap) {
  const Interval i = BootstrapInterval(values, MedianStatistic, bootstrap);
  return fmt::format("{} [{}, {}]", FiniteText(i.estimate, digits), FiniteText(i.low, digits),
                     FiniteText(i.high, digits));
}

double MeanNbv3d(const Nbv3dTrials& trials, double Nbv3dTrial::*value) {
  return Mean(EachNbv3d(trials, [&](const Nbv3dTrial& t) { return t.*value; }));
}

/// A row per planner, over all worlds and seeds. Where the target was not reached, the number of scans is
/// infinite, which a median can bear; "-" says that it is.
Table Nbv3dPlannerTable(const Nbv3dTrials& trials, double target, const BootstrapOptions& bootstrap) {
  Table table{{"planner", "runs", "reached %", fmt::format("scans to {} %", Percent(target)),
               fmt::format("way to {} % m", Percent(target)), "scans", "way m", "walls %", "mapped %",
               "surface %", "position cm", "map mean mm", "refused", "collisions", "ended %"},
              {}};
  for (const Nbv3dTrials& group : Nbv3dTrialsBy(&Nbv3dTrial::planner, trials)) {
    const auto median = [&](double Nbv3dTrial::*value, double per_unit, int digits) {
      return FiniteText(per_unit * Median(EachNbv3d(group, [&](const auto& t) { return t.*value; })),
                        digits);
    };
    const auto verdict = [&](double ScanLoopVerdict::*value, double per_unit) {
      return FiniteText(
          per_unit * Median(EachNbv3d(group, [&](const auto& t) { return t.verdict.*value; })), 1);
    };
    const auto reached = [](const Nbv3dTrial& t) { return std::isfinite(t.target_scans) ? 1.0 : 0.0; };
    table.rows.push_back(
        {group.front().planner, std::to_string(group.size()), Percent(Mean(EachNbv3d(group, reached))),
         MedianWithInterval(EachNbv3d(group, [](const auto& t) { return t.target_scans; }), 1, bootstrap),
         MedianWithInterval(EachNbv3d(group, [](const auto& t) { return t.target_path; }), 0, bootstrap),
         median(&Nbv3dTrial::scans, 1.0, 1), median(&Nbv3dTrial::path, 1.0, 0),
         median(&Nbv3dTrial::covered, 100.0, 1), median(&Nbv3dTrial::mapped, 100.0, 1),
         verdict(&ScanLoopVerdict::surface_covered, 100.0),
         verdict(&ScanLoopVerdict::translation_rms, 100.0),
         verdict(&ScanLoopVerdict::map_error_mean, 1000.0),
         fmt::format("{:.2f}", MeanNbv3d(group, &Nbv3dTrial::refused)),
         fmt::format("{:.2f}", MeanNbv3d(group, &Nbv3dTrial::collisions)),
         Percent(MeanNbv3d(group, &Nbv3dTrial::ended))});
  }
  return table;
}

/// A row per world and planner: medians over the seeds.
Table Nbv3dWorldTable(const Nbv3dTrials& trials, double target) {
  Table table{{"world", "planner", fmt::format("scans to {} %", Percent(target)), "scans", "way m",
               "walls %", "mapped %", "surface %", "position cm", "map mean mm", "refused", "collisions"},
              {}};
  for (const Nbv3dTrials& world : Nbv3dTrialsBy(&Nbv3dTrial::world, trials)) {
    for (const Nbv3dTrials& group : Nbv3dTrialsBy(&Nbv3dTrial::planner, world)) {
      const auto median = [&](const std::function<double(const Nbv3dTrial&)>& value, int digits) {
        return FiniteText(Median(EachNbv3d(group, value)), digits);
      };
      table.rows.push_back(
          {world.front().world, group.front().planner, median([](auto& t) { return t.target_scans; }, 1),
           median([](auto& t) { return t.scans; }, 1), median([](auto& t) { return t.path; }, 0),
           median([](auto& t) { return 100.0 * t.covered; }, 1),
           median([](auto& t) { return 100.0 * t.mapped; }, 1),
           median([](auto& t) { return 100.0 * t.verdict.surface_covered; }, 1),
           median([](auto& t) { return 100.0 * t.verdict.translation_rms; }, 1),
           median([](auto& t) { return 1000.0 * t.verdict.map_error_mean; }, 1),
           fmt::format("{:.2f}", MeanNbv3d(group, &Nbv3dTrial::refused)),
           fmt::format("{:.2f}", MeanNbv3d(group, &Nbv3dTrial::collisions))});
    }
  }
  return table;
}

/// Against the first planner, in pairs of the same world and seed: mean differences. Where the target was
/// not reached, `penalty` scans count, the most that were allowed: the least that it can have been.
Table Nbv3dDifferenceTable(const Nbv3dTrials& trials, double penalty, const BootstrapOptions& bootstrap) {
  Table table{{"planner", "pairs", "scans to target", "scans", "way m", "walls %", "surface %"}, {}};
  const std::vector<Nbv3dTrials> groups = Nbv3dTrialsBy(&Nbv3dTrial::planner, trials);
  for (std::size_t g = 1; g < groups.size(); ++g) {
    const auto difference = [&](double per_unit, const std::function<double(const Nbv3dTrial&)>& value) {
      const Interval i =
          BootstrapDifference(EachNbv3d(groups[g], value), EachNbv3d(groups[0], value), Mean, bootstrap);
      return fmt::format("{:+.1f} [{:+.1f}, {:+.1f}]", per_unit * i.estimate, per_unit * i.low,
                         per_unit * i.high);
    };
    table.rows.push_back(
        {groups[g].front().planner + " - " + groups[0].front().planner, std::to_string(groups[g].size()),
         difference(1.0, [&](auto& t) { return std::min(penalty, t.target_scans); }),
         difference(1.0, [](auto& t) { return t.scans; }), difference(1.0, [](auto& t) { return t.path; }),
         difference(100.0, [](auto& t) { return t.covered; }),
         difference(100.0, [](auto& t) { return t.verdict.surface_covered; })});
  }
  return table;
}

Json Nbv3dTimes(const Nbv3dTrials& trials) {
  Json json = Json::array();
  for (const Nbv3dTrial& t : trials) {
    json.push_back({{"world", t.world},
                    {"planner", t.planner},
                    {"seed", t.seed},
                    {"planning_seconds_per_scan", t.planning_seconds},
                    {"matching_seconds_per_scan", t.matching_seconds}});
  }
  return json;
}

std::string Nbv3dFileStem(const Nbv3dTrial& trial) {
  std::string stem = fmt::format("explorations/{}_{}_{}", trial.world, trial.planner, trial.seed);
  std::ranges::replace(stem, ' ', '_');
  return stem;
}

/// The runs of a study, one after another.
class Nbv3dRuns {
 public:
  Nbv3dRuns(const AblationNbv3dOptions& options, const RunDirectory& run, ProgressDisplay& progress)
      : options_(options), run_(run), progress_(progress), parallel_(options.threads) {}

  void Add(const ScanLoopWorld& world, const std::string& world_name, const Nbv3dWay& way, int seed,
           double done);
  const Nbv3dTrials& trials() const { return trials_; }
  const Parallel& parallel() const { return parallel_; }

 private:
  const AblationNbv3dOptions& options_;
  const RunDirectory& run_;
  ProgressDisplay& progress_;
  Parallel parallel_;
  Nbv3dTrials trials_;
};

void Nbv3dRuns::Add(const ScanLoopWorld& world, const std::string& world_name, const Nbv3dWay& way,
                    int seed, double done) {
  const std::string name = fmt::format("{}, {}, seed {}", world_name, way.name, seed);
  int scans = 0;
  const auto on_step = [&](const RobotScanStep& step) {
    progress_.Show(fmt::format("{}: scan {}, {:.0f} m, {} % of the walls; {}", name, ++scans, step.path,
                               Percent(step.covered), progress_.Eta(done)));
  };
  Explore3dOptions explore = way.explore;
  explore.robot.threads = options_.threads;
  explore.mapper.icp.threads = options_.threads;
  const Exploration3d exploration =
      Explore3d(world.scene, world.floor, explore, static_cast<std::uint64_t>(seed), on_step);
  Nbv3dTrial trial =
      SummarizeTrial(exploration, JudgeExploration(exploration, world, parallel_), options_.target);
  trial.world = world_name;
  trial.planner = way.name;
  trial.seed = seed;
  progress_.Keep(
      fmt::format("{}: {:.0f} scans, {:.0f} m, {} % of the walls, {} % of the surface, {:.1f} cm", name,
                  trial.scans, trial.path, Percent(trial.covered), Percent(trial.verdict.surface_covered),
                  100.0 * trial.verdict.translation_rms));
  run_.WriteCsv(Nbv3dFileStem(trial) + ".csv", RobotStepTable(exploration));
  slam::WriteSvg(run_.File(Nbv3dFileStem(trial) + ".svg"), DrawExploration(exploration, world.floor.floor));
  trials_.push_back(std::move(trial));
  run_.WriteCsv("trials.csv", Nbv3dTrialTable(trials_));
}

std::string ReportNbv3d(const AblationNbv3dOptions& options, const Nbv3dTrials& trials,
                        const RunDirectory& run) {
  std::string text;
  const auto keep = [&](const std::string& name, const std::string& heading, const Table& table) {
    if (table.rows.empty()) return;
    run.WriteCsv(name + ".csv", table);
    run.WriteText(name + ".tex", ToLatex(table));
    text += heading + "\n" + ToText(table) + "\n";
  };
  keep("planners", "planners over all worlds (medians; refused and collisions: means per run)",
       Nbv3dPlannerTable(trials, options.target, options.bootstrap));
  keep("differences", "against the first planner, in pairs (means with intervals)",
       Nbv3dDifferenceTable(trials, options.explore.max_scans, options.bootstrap));
  keep("worlds", "world by world (medians)", Nbv3dWorldTable(trials, options.target));
  run.WriteJson("timing.json", Nbv3dTimes(trials));
  return text;
}

}  // namespace

void CheckAblationNbv3d(const AblationNbv3dOptions& options) {
  CheckOptions(options);
  Nbv3dWays(options);
  ParseNumbers(options.explore.heights, "explore.heights");
  for (const std::string& world : ListedNames(options.worlds)) LoadNbvWorld(world, options);
}

std::string RunAblationNbv3d(const AblationNbv3dOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress) {
  const std::vector<std::string> worlds = ListedNames(options.worlds);
  const std::vector<Nbv3dWay> ways = Nbv3dWays(options);
  const std::size_t total = worlds.size() * ways.size() * static_cast<std::size_t>(options.seeds);
  WriteManifest(run, {});
  Nbv3dRuns runs(options, run, progress);
  for (const std::string& name : worlds) {
    progress.Show(ShortWorldName(name) + ": what there is to see");
    const ScanLoopWorld world =
        PrepareScanLoopWorld(LoadNbvWorld(name, options), options.explore, options.world, runs.parallel());
    for (const Nbv3dWay& way : ways) {
      for (int seed = 1; seed <= options.seeds; ++seed) {
        const std::size_t done = runs.trials().size();
        run.WriteProgress("running", done, total);
        runs.Add(world, ShortWorldName(name), way, seed,
                 static_cast<double>(done) / static_cast<double>(total));
      }
    }
  }
  std::string text = ReportNbv3d(options, runs.trials(), run);
  FinishRun(run, "Next best views with 3D scans and registration", total);
  return text;
}

}  // namespace ariadne::experiments
