#include "experiments/studies/ablation_features.h"

#include <fmt/format.h>

#include <sstream>

#include "experiments/metrics/statistics.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/feature_trials.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

std::string Degrees(const std::vector<double>& angles) {
  return angles.empty() ? "-" : fmt::format("{:.3f}", slam::DegFromRad(Median(angles)));
}
std::string Millimetres(const std::vector<double>& lengths) {
  return lengths.empty() ? "-" : fmt::format("{:.2f}", 1e3 * Median(lengths));
}
std::string Share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : fmt::format("{:.3f}", static_cast<double>(part) / static_cast<double>(whole));
}

Table LineTable(const std::vector<LineDetector>& detectors, const std::vector<LineTrial>& trials) {
  Table table{
      {"detector", "walls", "recall", "precision", "angle_deg", "offset_mm", "ends_mm", "ends_within_5cm"},
      {}};
  for (std::size_t d = 0; d < detectors.size(); ++d) {
    const LineScore& score = trials[d].score;
    table.rows.push_back({detectors[d].name, std::to_string(score.walls),
                          fmt::format("{:.3f}", score.Recall()), fmt::format("{:.3f}", score.Precision()),
                          Degrees(score.angles), Millimetres(score.offsets), Millimetres(score.ends),
                          fmt::format("{:.3f}", score.ShareOfEndsWithin(0.05))});
  }
  return table;
}

Table SurfaceTable(const std::vector<SurfaceTrial>& trials) {
  Table table{{"method", "planes", "recall", "surfaces", "precision", "angle_deg", "offset_mm", "cover",
               "pieces_per_plane"},
              {}};
  for (std::size_t m = 0; m < trials.size(); ++m) {
    const SurfaceScore& score = trials[m].score;
    table.rows.push_back(
        {std::string(EnumNames<slam::SurfaceMethod>::value[m]), std::to_string(score.patches),
         fmt::format("{:.3f}", score.Recall()), std::to_string(score.surfaces),
         fmt::format("{:.3f}", score.Precision()), Degrees(score.angles), Millimetres(score.offsets),
         fmt::format("{:.3f}", Median(score.covers)), fmt::format("{:.2f}", Mean(score.pieces))});
  }
  return table;
}

Table LogTable(const std::string& log, const std::vector<LineDetector>& detectors,
               const std::vector<LogTrial>& trials, Table table) {
  table.columns = {"log",    "detector",    "sweeps",    "lines_per_sweep", "points_explained",
                   "rms_mm", "found_again", "angle_deg", "offset_mm"};
  for (std::size_t d = 0; d < detectors.size(); ++d) {
    const LogTrial& trial = trials[d];
    table.rows.push_back(
        {log, detectors[d].name, std::to_string(trial.sweeps),
         fmt::format("{:.2f}", static_cast<double>(trial.lines) / static_cast<double>(trial.sweeps)),
         Share(trial.explained, trial.points), Millimetres(trial.rms),
         Share(trial.repeated, trial.repeatable), Degrees(trial.angles), Millimetres(trial.offsets)});
  }
  return table;
}

template <typename Trial>
Json MedianSeconds(const std::vector<Trial>& trials) {
  Json json = Json::array();
  for (const Trial& trial : trials) json.push_back(trial.seconds.empty() ? 0.0 : Median(trial.seconds));
  return json;
}

/// The logs that are there, by the names as they were given.
std::vector<std::string> LogsOf(const AblationFeaturesOptions& options) {
  std::vector<std::string> logs;
  std::istringstream stream(options.logs);
  for (std::string log; std::getline(stream >> std::ws, log, ',');) {
    if (std::filesystem::exists(ExpandDataPath(log))) logs.push_back(log);
  }
  return logs;
}

}  // namespace

std::string RunAblationFeatures(const AblationFeaturesOptions& options, const RunDirectory& run,
                                ProgressDisplay& progress) {
  const std::vector<std::string> logs = LogsOf(options);
  std::vector<std::filesystem::path> files;
  for (const std::string& log : logs) files.push_back(ExpandDataPath(log));
  WriteManifest(run, files);
  const auto showing = [&](const char* what, int rooms) {
    return [&progress, what, rooms](int room) {
      progress.Show(fmt::format("{}: room {} of {}", what, room + 1, rooms));
    };
  };
  const std::vector<LineDetector> detectors = LineDetectors(options.detect.lines);
  run.WriteProgress("running", 0, 2 + logs.size());
  const std::vector<LineTrial> lines = TryLines(detectors, options.line_rooms, options.seed,
                                                options.scanner, showing("lines", options.line_rooms));
  run.WriteProgress("running", 1, 2 + logs.size());
  const std::vector<SurfaceTrial> surfaces =
      TrySurfaces(options.detect, options.surface_rooms, options.seed, options.scanner,
                  showing("surfaces", options.surface_rooms));
  Json timing{{"lines_median_s", MedianSeconds(lines)}, {"surfaces_median_s", MedianSeconds(surfaces)}};
  Table log_table;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    run.WriteProgress("running", 2 + i, 2 + logs.size());
    progress.Show(logs[i]);
    const std::vector<LogTrial> trials = TryLog(detectors, files[i], options.log_every);
    log_table = LogTable(files[i].filename().string(), detectors, trials, std::move(log_table));
    timing[files[i].filename().string() + "_median_s"] = MedianSeconds(trials);
  }
  const Table line_table = LineTable(detectors, lines), surface_table = SurfaceTable(surfaces);
  run.WriteCsv("lines.csv", line_table);
  run.WriteCsv("surfaces.csv", surface_table);
  if (!logs.empty()) run.WriteCsv("logs.csv", log_table);
  run.WriteJson("timing.json", timing);
  FinishRun(run, "Detectors of lines and surfaces", 2 + logs.size());
  return fmt::format("lines of {} rooms\n{}\nsurfaces of {} rooms\n{}\n{}", options.line_rooms,
                     ToText(line_table), options.surface_rooms, ToText(surface_table),
                     logs.empty() ? "no logs: set ARIADNE_DATA\n" : "real sweeps\n" + ToText(log_table));
}

}  // namespace ariadne::experiments
