#include "experiments/studies/ablation_nbv.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/nbv_bounds.h"
#include "experiments/studies/nbv_tables.h"
#include "experiments/studies/nbv_variants.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

/// "a, b c, ..." without the spaces around the commas.
std::vector<std::string> Names(const std::string& text, const std::string& where) {
  std::vector<std::string> names{""};
  for (const char c : text) {
    if (c == ',') names.emplace_back();
    if (c != ',' && (c != ' ' || !names.back().empty())) names.back() += c;
  }
  for (std::string& name : names) name.erase(name.find_last_not_of(' ') + 1);
  if (std::ranges::count(names, "") > 0)
    Fail("{} is '{}', where names are to stand: a, b, ...", where, text);
  return names;
}

std::vector<std::string> PlansOfData() {
  const fs::path folder = ExpandDataPath("$ARIADNE_DATA/plans");
  std::vector<std::string> plans;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") plans.push_back(entry.path().string());
    }
  }
  if (plans.empty())
    Fail("{} has no floor plans; set ARIADNE_DATA, or name worlds as floors", folder.string());
  std::ranges::sort(plans);
  return plans;
}

std::vector<std::string> WorldsOf(const AblationNbvOptions& options) {
  std::vector<std::string> worlds;
  for (const std::string& name : Names(options.floors, "floors")) {
    const std::vector<std::string> some = name == "plans" ? PlansOfData() : std::vector{name};
    worlds.insert(worlds.end(), some.begin(), some.end());
  }
  return worlds;
}

/// Of the variants those with these names, and `default`; all of them where the one name is `all`.
void KeepOnly(const std::vector<std::string>& names, std::vector<NbvVariant>& variants) {
  if (names == std::vector<std::string>{"all"}) return;
  for (const std::string& name : names) {
    if (std::ranges::find(variants, name, &NbvVariant::name) == variants.end())
      Fail("variants names '{}', which none of the studies has", name);
  }
  std::erase_if(variants, [&](const NbvVariant& variant) {
    return variant.name != "default" && std::ranges::find(names, variant.name) == names.end();
  });
}

std::vector<NbvVariant> VariantsOf(const AblationNbvOptions& options) {
  const std::vector<std::string> studies = Names(options.studies, "studies");
  if (studies.front() != "policies") Fail("studies must begin with policies: they hold the default");
  std::vector<NbvVariant> variants;
  for (const std::string& study : studies) {
    for (NbvVariant& variant : NbvVariants(study, options.explore)) variants.push_back(std::move(variant));
  }
  KeepOnly(Names(options.variants, "variants"), variants);
  return variants;
}

struct NbvTask {
  const NbvVariant* variant;
  std::uint64_t seed;
};

/// All variants from all starts.
std::vector<NbvTask> TasksOf(const std::vector<NbvVariant>& variants, const AblationNbvOptions& options) {
  std::vector<NbvTask> tasks;
  for (const NbvVariant& variant : variants) {
    const int wanted = variant.study == "policies" ? options.policy_seeds : options.study_seeds;
    const int seeds = variant.name == "default" ? options.seeds : std::min(options.seeds, wanted);
    for (int k = 0; k < seeds; ++k)
      tasks.push_back({&variant, static_cast<std::uint64_t>(options.first_seed + k)});
  }
  return tasks;
}

std::vector<NbvTrial> TryFloor(const NbvFloor& floor, const std::vector<NbvTask>& tasks, double share,
                               const Parallel& parallel) {
  std::vector<NbvTrial> trials(tasks.size());
  parallel.For(tasks.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
    trials[i] = TryNbv(floor, *tasks[i].variant, share, tasks[i].seed);
  });
  return trials;
}

Json PlanningTimes(const Table& times) {
  Json json = Json::array();
  for (const auto& row : times.rows) {
    Json entry;
    for (std::size_t c = 0; c < row.size(); ++c) entry[times.columns[c]] = row[c];
    json.push_back(entry);
  }
  return json;
}

std::string Report(const AblationNbvOptions& options, const std::vector<NbvTrial>& trials,
                   const std::vector<NbvFloorSummary>& floors, const RunDirectory& run) {
  std::string text;
  const auto keep = [&](const std::string& name, const Table& table) {
    run.WriteCsv(name + ".csv", table);
    run.WriteText(name + ".tex", ToLatex(table));
    text += ToText(table) + "\n";
  };
  keep("floors", NbvFloorTable(trials, floors));
  for (const std::string& study : Names(options.studies, "studies")) {
    keep(study, NbvStudyTable(trials, study, options.bootstrap));
  }
  run.WriteCsv("curves.csv", NbvCurveTable(trials));
  const Table times = NbvTimeTable(trials);
  run.WriteJson("timing.json", PlanningTimes(times));
  return text + ToText(times);
}

}  // namespace

void CheckAblationNbv(const AblationNbvOptions& options) {
  VariantsOf(options);
  WorldsOf(options);
}

std::string RunAblationNbv(const AblationNbvOptions& options, const RunDirectory& run,
                           ProgressDisplay& progress) {
  const std::vector<std::string> worlds = WorldsOf(options);
  const std::vector<NbvVariant> variants = VariantsOf(options);
  const std::vector<NbvTask> tasks = TasksOf(variants, options);
  const Parallel parallel(options.threads);
  NbvFloorOptions floor_options = options.floor;
  floor_options.bound.cover.share = options.share;
  WriteManifest(run, {});
  NbvBounds bounds(floor_options, options.explore.scanner);
  if (!options.bounds_of.empty()) bounds.Read(options.bounds_of);
  std::vector<NbvTrial> trials;
  std::vector<NbvFloorSummary> floors;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    run.WriteProgress("running", i, worlds.size());
    const double done = static_cast<double>(i) / static_cast<double>(worlds.size());
    progress.Show(fmt::format("floor {} of {}: {}, {}", i + 1, worlds.size(),
                              fs::path(worlds[i]).stem().string(), progress.Eta(done)));
    NbvFloor floor = PrepareFloor(worlds[i], floor_options, options.explore.scanner, parallel);
    floor.bound = bounds.Of(floor, parallel);
    floors.push_back({floor.floor.name,
                      static_cast<double>(floor.reachable.size()) * options.floor.cover.resolution *
                          options.floor.cover.resolution,
                      static_cast<double>(floor.cover.places_map.size()) * floor.cover.length_each,
                      floor.bound.views.size(), floor.bound.lower_bound});
    for (NbvTrial& trial : TryFloor(floor, tasks, options.share, parallel))
      trials.push_back(std::move(trial));
    run.WriteCsv("trials.csv", NbvTrialTable(trials));
    bounds.Write(run);
    progress.Keep(fmt::format("{}: {} explorations, at least {} views", floor.floor.name, tasks.size(),
                              floor.bound.lower_bound));
  }
  std::string text = Report(options, trials, floors, run);
  FinishRun(run, "Next best views: policies and parameters", worlds.size());
  return text;
}

}  // namespace ariadne::experiments
