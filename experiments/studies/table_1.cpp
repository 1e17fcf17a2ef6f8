#include "experiments/studies/table_1.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/reduce/reduce.h"
#include "slam/registration/align.h"

namespace ariadne::experiments {
namespace {

/// A row of the table, with what the paper reports of it on a Pentium-III-800.
struct PaperRow {
  std::string points;
  slam::Search search;
  double paper_seconds;
  int paper_iterations;
};

const std::vector<PaperRow> kRows{{"all", slam::Search::kBruteForce, 3 * 3600.0 + 47 * 60.0, 27},
                                  {"reduced", slam::Search::kBruteForce, 3 * 60.0 + 6.0, 25},
                                  {"all", slam::Search::kKdTree, 6.0, 27},
                                  {"reduced", slam::Search::kKdTree, 1.4, 25}};

struct Measured {
  slam::AlignResult align;
  double seconds = 0.0;  // median of the whole alignment, building the tree included
};

Measured Measure(const slam::PointCloud& model, const slam::PointCloud& data,
                 const slam::Pose3& T_model_data_guess, const slam::AlignOptions& icp, int repeats) {
  Measured measured;
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const Stopwatch watch;
    measured.align = slam::Align(model, data, T_model_data_guess, icp);
    seconds.push_back(watch.Seconds());
  }
  std::nth_element(seconds.begin(), seconds.begin() + repeats / 2, seconds.end());
  measured.seconds = seconds[static_cast<std::size_t>(repeats / 2)];
  return measured;
}

Json ToJson(const PaperRow& row, std::size_t points, const slam::AlignResult& align) {
  const Eigen::Vector3d& t = align.T_model_data.translation;
  const Eigen::Quaterniond& q = align.T_model_data.rotation;
  return {{"points", row.points},
          {"search", NameOf(row.search)},
          {"data_points", points},
          {"status", Name(align.status)},
          {"iterations", align.iterations.size()},
          {"pairs", align.pairs},
          {"rms_m", align.rms},
          {"T_model_data", {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}}};
}

}  // namespace

std::string RunTable1(const Table1Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  const ScanPair pair = ReadScanPair(options);
  WriteManifest(run, pair.files);
  Json metrics = Json::array(), timing = Json::array();
  std::vector<Measured> measured;
  Table table{
      {"points", "search", "time", "iterations", "ratio", "paper", "paper iterations", "paper ratio"}, {}};
  for (const PaperRow& row : kRows) {
    progress.Keep(fmt::format("{} points, {} ...", row.points, NameOf(row.search)));
    run.WriteProgress("running", measured.size(), kRows.size());
    const bool reduce = row.points == "reduced";
    const slam::PointCloud model = reduce ? slam::Reduce(pair.model, options.reduce) : pair.model;
    const slam::PointCloud data = reduce ? slam::Reduce(pair.data, options.reduce) : pair.data;
    slam::AlignOptions icp = options.icp;
    icp.search = row.search;
    const int repeats = row.search == slam::Search::kBruteForce ? 1 : options.repeats;
    measured.push_back(Measure(model, data, pair.T_model_data_guess, icp, repeats));
    metrics.push_back(ToJson(row, data.size(), measured.back().align));
    timing.push_back(
        {{"points", row.points}, {"search", NameOf(row.search)}, {"seconds", measured.back().seconds}});
    table.rows.push_back({fmt::format("{} ({})", row.points, data.size()), std::string(NameOf(row.search)),
                          fmt::format("{:.4g} s", measured.back().seconds),
                          std::to_string(measured.back().align.iterations.size()), "",
                          fmt::format("{:.4g} s", row.paper_seconds), std::to_string(row.paper_iterations),
                          fmt::format("{:.3g}", row.paper_seconds / kRows.back().paper_seconds)});
  }
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    table.rows[i][4] = fmt::format("{:.3g}", measured[i].seconds / measured.back().seconds);
  }
  run.WriteJson("metrics.json", metrics);
  run.WriteJson("timing.json", timing);
  FinishRun(run, "Table 1: all and reduced points, brute force and k-d tree", kRows.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
