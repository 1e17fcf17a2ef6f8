#include "experiments/studies/optimize.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/config/options_io.h"
#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/graph_output.h"
#include "experiments/studies/graph_tables.h"
#include "slam/base/error.h"
#include "slam/base/stopwatch.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kWorstEdges = 10;
constexpr std::size_t kListedRejections = 20;  // in the summary; edges.csv has all

slam::G2oFile ReadGraph(const OptimizeOptions& options) {
  if (options.file.empty()) Fail("which graph? Name a .g2o file: ariadne optimize FILE --out RUN");
  return slam::ReadFile(ExpandDataPath(options.file), slam::ReadG2o);
}

/// How many closures a robust kernel has turned off, and in which lines they stand.
template <typename Pose>
std::string RejectionText(const slam::G2oFile& file, const slam::OptimizeResult<Pose>& minimum) {
  if (minimum.edge_weights.empty()) return "";
  std::vector<std::size_t> lines;
  for (const std::size_t edge : RejectedEdges(minimum.edge_weights)) lines.push_back(file.edge_lines[edge]);
  const std::size_t count = lines.size();
  lines.resize(std::min(count, kListedRejections));
  return fmt::format("rejected closures: {}{}{}{}\n", count, count > 0 ? ", in lines " : "",
                     fmt::join(lines, ", "), count > lines.size() ? ", ... (edges.csv has all)" : "");
}

template <typename Pose>
std::string SummaryText(const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph,
                        const GraphMinima<Pose>& minima, const Table& edges, const Json& times) {
  const Json metrics = MetricsOf(file, graph, minima);
  std::string text = fmt::format("{} vertices, {} edges, {} of them closures\n", graph.nodes.size(),
                                 graph.edges.size(), metrics.at("closures").template get<std::size_t>());
  for (const auto& note : metrics.at("notes"))
    text += fmt::format("note: {}\n", note.template get<std::string>());
  text += fmt::format("\n{}\n{}", ToText(MinimaTable(minima)), RejectionText(file, minima.best()));
  if (minima.certificate) text += minima.certificate->message + "\n";
  text += fmt::format("\n{}\nworst edges (squared errors):\n{}", ToText(TimeTable(times)),
                      ToText(WorstEdges(edges, kWorstEdges)));
  return text;
}

template <typename Pose>
std::string ProblemOf(const GraphMinima<Pose>& minima) {
  for (const auto& minimum : {&minima.isotropic, &minima.information}) {
    if (*minimum && (*minimum)->status != slam::GraphStatus::kConverged) return (*minimum)->message;
  }
  return "";
}

/// Writes how certain the poses are; returns how long that took. [s]
template <typename Pose>
double WriteCovariances(const slam::OptimizeResult<Pose>& minimum, const RunDirectory& run) {
  const Stopwatch watch;
  const auto covariances = slam::MarginalCovariances(minimum.graph, {}, minimum.edge_weights);
  run.WriteCsv("covariances.csv", SigmaTable(minimum.graph, covariances));
  return watch.Seconds();
}

template <typename Pose>
OptimizeSummary OptimizeFile(const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph,
                             const OptimizeOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress, Json times) {
  const GraphMinima<Pose> minima = FindMinima(file, graph, options, progress);
  times.update(TimesOf(minima));
  if (options.covariances) times["covariances_s"] = WriteCovariances(minima.best(), run);
  const Stopwatch writing;
  const Table edges = EdgeTable(file, graph, minima.best());
  run.WriteCsv("edges.csv", edges);
  run.WriteCsv("iterations.csv", IterationTable(minima));
  run.WriteJson("metrics.json", MetricsOf(file, graph, minima));
  WriteOptimizedGraph(graph, minima.best(), options, run);
  times["write_s"] = writing.Seconds();
  run.WriteJson("timing.json", times);
  return {SummaryText(file, graph, minima, edges, times), ProblemOf(minima)};
}

}  // namespace

void CheckOptimizeInput(const OptimizeOptions& options) {
  RequireObjective(ReadGraph(options), options.objective);
}

OptimizeSummary RunOptimize(const OptimizeOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress) {
  run.WriteConfig("experiment: optimize\n" + WriteOptions(options));
  WriteManifest(run, {ExpandDataPath(options.file)});
  const Stopwatch reading;
  const slam::G2oFile file = ReadGraph(options);
  const Json times = {{"read_s", reading.Seconds()}};
  for (const std::string& note : file.notes) progress.Keep(note);
  const OptimizeSummary summary = std::visit(
      [&](const auto& graph) { return OptimizeFile(file, graph, options, run, progress, times); },
      file.graph);
  FinishRun(run, fmt::format("Optimization of {}", std::filesystem::path(options.file).filename().string()),
            1);
  return summary;
}

}  // namespace ariadne::experiments
