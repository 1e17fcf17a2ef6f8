#include "experiments/studies/posegraph_benchmark.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "experiments/run/data_path.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/graph_minima.h"
#include "experiments/studies/graph_tables.h"
#include "slam/base/error.h"
#include "slam/base/stopwatch.h"
#include "slam/io/file.h"
#include "slam/io/scan_list.h"

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

/// What was found out about one graph.
struct FileRow {
  std::string name;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  double guess = 0.0;  // isotropic objective at the file's poses, at the start, and at the minimum
  double start = 0.0;
  double minimum = 0.0;
  std::size_t iterations = 0;
  slam::Certificate certificate;
  std::optional<double> known;        // minimum
  std::optional<double> information;  // minimum of the file's own objective; none: unbounded
  std::optional<double> from_guess;   // where a start from the file's poses ends
  std::optional<slam::Certificate> guess_certificate;
  Json seconds;

  double Difference() const { return known ? std::abs(minimum - *known) / *known : 0.0; }
};

std::vector<fs::path> FindGraphs(const std::string& folder) {
  const fs::path path = ExpandDataPath(folder);
  std::vector<fs::path> graphs;
  std::error_code error;
  fs::directory_iterator entries(path, error);
  if (error) Fail("{}: the folder cannot be read: {}", path.string(), error.message());
  for (const fs::directory_entry& entry : entries) {
    if (entry.path().extension() == ".g2o") graphs.push_back(entry.path());
  }
  if (graphs.empty()) Fail("{}: holds no graphs (.g2o)", path.string());
  std::ranges::sort(graphs, [](const fs::path& a, const fs::path& b) {
    return slam::NaturallyBefore(a.filename().string(), b.filename().string());
  });
  return graphs;
}

/// "name value, name value, ..."
std::map<std::string, double> ParseOptima(const std::string& text) {
  std::map<std::string, double> optima;
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    std::istringstream words(entry);
    std::string name, rest;
    double value = 0.0;
    if (!(words >> name >> value) || words >> rest || !(value > 0.0))
      Fail("optima: '{}' is not a name and a positive number; separate entries by commas", entry);
    optima[name] = value;
  }
  return optima;
}

template <typename Pose>
void MeasureGraph(FileRow& row, const slam::G2oFile& file, const slam::PoseGraph<Pose>& graph,
                  const PosegraphBenchmarkOptions& options, ProgressDisplay& progress) {
  OptimizeOptions optimize;
  optimize.graph = options.graph;
  optimize.certify = true;
  const bool bounded = FindObstacles(file, graph).information.empty();
  optimize.objective = bounded ? GraphObjective::kBoth : GraphObjective::kIsotropic;
  const GraphMinima<Pose> minima = FindMinima(file, graph, optimize, progress);
  row.vertices = graph.nodes.size();
  row.edges = graph.edges.size();
  row.guess = minima.isotropic->objective_guess;
  row.start = minima.isotropic->objective_start;
  row.minimum = minima.isotropic->objective;
  row.iterations = minima.isotropic->iterations.size();
  row.certificate = minima.certificate.value();
  if (bounded) row.information = minima.information->objective;
  row.seconds.update(TimesOf(minima));
  if (!options.from_guess) return;
  optimize.objective = GraphObjective::kIsotropic;
  optimize.graph.start = slam::GraphStart::kGuess;
  const GraphMinima<Pose> from_guess = FindMinima(file, graph, optimize, progress);
  row.from_guess = from_guess.isotropic->objective;
  row.guess_certificate = from_guess.certificate;
  row.seconds["from_guess"] = TimesOf(from_guess);
}

FileRow MeasureFile(const fs::path& path, const PosegraphBenchmarkOptions& options,
                    ProgressDisplay& progress) {
  FileRow row;
  row.name = path.stem().string();
  progress.Keep(row.name);
  const auto optima = ParseOptima(options.optima);
  if (const auto known = optima.find(row.name); known != optima.end()) row.known = known->second;
  const Stopwatch reading;
  const slam::G2oFile file = slam::ReadFile(path, slam::ReadG2o);
  row.seconds = {{"read_s", reading.Seconds()}};
  std::visit([&](const auto& graph) { MeasureGraph(row, file, graph, options, progress); }, file.graph);
  return row;
}

/// All numbers with `digits`, or with all their digits where it is 0.
Table GraphTable(const std::vector<FileRow>& rows, int digits) {
  const auto number = [digits](double value) {
    return digits > 0 ? fmt::format("{:.{}g}", value, digits) : Exact(value);
  };
  Table table{{"graph", "vertices", "edges", "F guess", "F start", "F", "known F", "difference", "verdict",
               "gap", "iterations", "information", "F from guess", "verdict from guess"},
              {}};
  for (const FileRow& row : rows) {
    table.rows.push_back(
        {row.name, std::to_string(row.vertices), std::to_string(row.edges), number(row.guess),
         number(row.start), number(row.minimum), row.known ? Exact(*row.known) : "",
         row.known ? fmt::format("{:.1e}", row.Difference()) : "", std::string(VerdictOf(row.certificate)),
         fmt::format("{:.1e}", row.certificate.relative_gap), std::to_string(row.iterations),
         row.information ? number(*row.information) : "unbounded",
         row.from_guess ? number(*row.from_guess) : "",
         row.guess_certificate ? std::string(VerdictOf(*row.guess_certificate)) : ""});
  }
  return table;
}

Table SecondsTable(const std::vector<FileRow>& rows) {
  Table table{{"graph", "read", "optimize", "of it start", "symbolic", "linearize", "factorize", "solve",
               "certificate", "[ms]"},
              {}};
  for (const FileRow& row : rows) {
    const Json& isotropic = row.seconds.at("isotropic_s");
    std::vector<std::string> cells{row.name};
    const auto add = [&](const Json& seconds) {
      cells.push_back(fmt::format("{:.1f}", 1e3 * seconds.get<double>()));
    };
    add(row.seconds.at("read_s"));
    for (const char* phase : {"total", "start", "symbolic", "linearize", "factorize", "solve"})
      add(isotropic.at(phase));
    add(row.seconds.at("certificate_s"));
    cells.emplace_back("");
    table.rows.push_back(cells);
  }
  return table;
}

Json ToJson(const FileRow& row) {
  Json json = {{"graph", row.name},
               {"objective", row.minimum},
               {"verdict", VerdictOf(row.certificate)},
               {"relative_gap", row.certificate.relative_gap}};
  if (row.known) json["known_objective"] = *row.known;
  if (row.known) json["relative_difference"] = row.Difference();
  if (row.information) json["information_objective"] = *row.information;
  if (row.from_guess) json["objective_from_guess"] = *row.from_guess;
  if (row.guess_certificate) json["verdict_from_guess"] = VerdictOf(*row.guess_certificate);
  return json;
}

std::string ProblemOf(const std::vector<FileRow>& rows, double tolerance) {
  std::vector<std::string> missed;
  for (const FileRow& row : rows) {
    const bool certified = row.certificate.verdict == slam::CertificateVerdict::kOptimal;
    if (row.known && (row.Difference() > tolerance || !certified)) missed.push_back(row.name);
  }
  if (missed.empty()) return "";
  return fmt::format("the known optimum is not reached or not certified on {}", fmt::join(missed, ", "));
}

}  // namespace

void CheckPosegraphBenchmark(const PosegraphBenchmarkOptions& options) {
  ParseOptima(options.optima);
  FindGraphs(options.folder);
}

PosegraphBenchmarkSummary RunPosegraphBenchmark(const PosegraphBenchmarkOptions& options,
                                                const RunDirectory& run, ProgressDisplay& progress) {
  const std::vector<fs::path> graphs = FindGraphs(options.folder);
  WriteManifest(run, graphs);
  std::vector<FileRow> rows;
  Json metrics = Json::array(), timing = Json::object();
  for (const fs::path& graph : graphs) {
    run.WriteProgress("running", rows.size(), graphs.size());
    rows.push_back(MeasureFile(graph, options, progress));
    metrics.push_back(ToJson(rows.back()));
    timing[rows.back().name] = rows.back().seconds;
  }
  run.WriteCsv("graphs.csv", GraphTable(rows, 0));
  run.WriteJson("metrics.json", metrics);
  run.WriteJson("timing.json", timing);
  FinishRun(run, "Pose graphs: minima, certificates, and where the files' own poses lead", graphs.size());
  return {fmt::format("{}\n{}", ToText(GraphTable(rows, 9)), ToText(SecondsTable(rows))),
          ProblemOf(rows, options.tolerance)};
}

}  // namespace ariadne::experiments
