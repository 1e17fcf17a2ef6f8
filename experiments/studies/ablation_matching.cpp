#include "experiments/studies/ablation_matching.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "experiments/metrics/statistics.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/matching_table.h"
#include "experiments/studies/matching_ways.h"
#include "slam/base/error.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kTrialsCheckpoint = "checkpoint.json";
constexpr const char* kReference = "simultaneous";
using Methods = std::vector<std::string>;

Methods ParseMethods(const std::string& names) {
  const std::vector<std::string> ways = MatchingWays();
  Methods methods;
  std::istringstream stream(names);
  for (std::string name; std::getline(stream >> std::ws, name, ',');) {
    if (std::ranges::find(ways, name) == ways.end())
      Fail("methods: {} is none of {}", name, fmt::join(ways, ", "));
    methods.push_back(name);
  }
  if (std::ranges::find(methods, kReference) == methods.end())
    Fail("methods: {} is missing, against which the others are compared", kReference);
  return methods;
}

std::vector<LabelledTrial> TrialsSoFar(const RunDirectory& run) {
  std::vector<LabelledTrial> trials;
  if (!std::filesystem::exists(run.path() / kTrialsCheckpoint)) return trials;
  for (const Json& trial : Json::parse(run.ReadText(kTrialsCheckpoint)))
    trials.push_back(LabelledTrialFromJson(trial));
  return trials;
}

void WriteCheckpoint(const std::vector<LabelledTrial>& trials, const RunDirectory& run) {
  Json json = Json::array();
  for (const LabelledTrial& trial : trials) json.push_back(ToJson(trial));
  run.WriteJson(kTrialsCheckpoint, json);
}

/// All methods on one tour, with the odometry for comparison, and the truth for what the scanner leaves.
std::vector<LabelledTrial> RunTour(const AblationMatchingOptions& options, const Methods& methods,
                                   double noise, int seed, const TrueBuilding& building,
                                   const Parallel& parallel) {
  TourOptions tour_options = options.input.tour;
  tour_options.odometry_noise = noise;
  tour_options.seed = seed;
  const TourScans scans = TakeTourScans(SimulatedTour(tour_options), building, parallel);
  std::vector<slam::Pose3> T_odom_laser;
  for (const slam::PosedCloud& scan : scans.scans) T_odom_laser.push_back(scan.T_map_laser);
  std::vector<LabelledTrial> trials{
      {noise, seed, "odometry", JudgePoses(scans, building, T_odom_laser, parallel)}};
  for (const std::string& method : methods) {
    trials.push_back(
        {noise, seed, method, TryMatching(scans, building, MatchedBy(method, options.mapper), parallel)});
  }
  trials.push_back({noise, seed, "truth", JudgePoses(scans, building, scans.T_map_laser_true, parallel)});
  return trials;
}

/// Median seconds of each method over all tours.
Json TimingOf(const std::vector<LabelledTrial>& trials, const Methods& methods) {
  Json timing;
  for (const std::string& method : methods) {
    std::vector<double> seconds;
    for (const LabelledTrial& t : trials) {
      if (t.method == method) seconds.push_back(t.trial.seconds);
    }
    timing[method] = {{"median_s", Median(seconds)}};
  }
  return timing;
}

std::string Report(const AblationMatchingOptions& options, const Methods& methods,
                   const std::vector<LabelledTrial>& trials, const RunDirectory& run) {
  const Table medians = MedianTable(trials, options.bootstrap);
  const Table paired = PairedTable(trials, kReference, options.bootstrap);
  run.WriteCsv("trials.csv", TrialTable(trials));
  run.WriteCsv("medians.csv", medians);
  run.WriteCsv("paired.csv", paired);
  run.WriteText("medians.tex", ToLatex(medians));
  run.WriteText("paired.tex", ToLatex(paired));
  run.WriteJson("timing.json", TimingOf(trials, methods));
  return fmt::format("medians over {} tours with their {:.0f} % intervals\n{}\npaired differences\n{}",
                     options.seeds, 100.0 * options.bootstrap.confidence, ToText(medians), ToText(paired));
}

}  // namespace

std::string RunAblationMatching(const AblationMatchingOptions& options, const RunDirectory& run,
                                ProgressDisplay& progress) {
  if (options.input.folder != "builtin:tour") {
    Fail("ablation_matching needs the truth of many tours: input.folder must be builtin:tour, not {}",
         options.input.folder);
  }
  const std::vector<double> levels = ParseNumbers(options.noise_levels, "noise_levels");
  const Methods methods = ParseMethods(options.methods);
  WriteManifest(run, {});
  const TrueBuilding building(SimulatedTour(options.input.tour).scene().world());
  const Parallel parallel(options.threads);
  std::vector<LabelledTrial> trials = TrialsSoFar(run);
  const std::size_t per_tour = methods.size() + 2;
  const std::size_t tours = levels.size() * static_cast<std::size_t>(options.seeds);
  for (std::size_t i = trials.size() / per_tour; i < tours; ++i) {
    run.WriteProgress("running", i, tours);
    const double noise = levels[i / static_cast<std::size_t>(options.seeds)];
    const int seed = options.input.tour.seed + static_cast<int>(i) % options.seeds;
    progress.Show(fmt::format("tour {} of {}: noise {}, seed {}, {}", i + 1, tours, noise, seed,
                              progress.Eta(static_cast<double>(i) / static_cast<double>(tours))));
    for (LabelledTrial& trial : RunTour(options, methods, noise, seed, building, parallel)) {
      trials.push_back(std::move(trial));
    }
    WriteCheckpoint(trials, run);
  }
  std::string text = Report(options, methods, trials, run);
  std::filesystem::remove(run.path() / kTrialsCheckpoint);
  FinishRun(run, "Ways of matching many scans, on simulated tours", tours);
  return text;
}

}  // namespace ariadne::experiments
