#include "experiments/studies/planning_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numbers>
#include <vector>

#include "experiments/exploration/pieced_building.h"
#include "experiments/metrics/statistics.h"
#include "experiments/report/log_plot.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "slam/base/stopwatch.h"

namespace ariadne::experiments {
namespace {

/// What was measured for one pair of numbers.
struct PlanningTimes {
  int candidates = 0, edges = 0;
  std::vector<double> whole, choice;  // of each decision [ms]
};

std::vector<int> CountsIn(const std::string& text, const std::string& where) {
  std::vector<int> counts;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    while (at != end && (*at == ' ' || *at == ',')) ++at;
    int count = 0;
    const auto [next, error] = std::from_chars(at, end, count);
    if (error != std::errc() || count < 1 || count > 100000)
      Fail("{} is '{}', where numbers from 1 to 100000 are to stand: a, b, ...", where, text);
    counts.push_back(count);
    at = next;
  }
  if (counts.empty()) Fail("{} names no number", where);
  return counts;
}

/// A place with room for the robot, and any heading.
slam::Pose2 DrawRobot(const planning::LabelledPolygon& building, RandomStream& stream) {
  const std::vector<planning::Edge> edges = planning::EdgesOf(std::span(&building, 1));
  for (;;) {
    const double x = DrawUniform(stream, 0.0, 30.0), y = DrawUniform(stream, 0.0, 20.0);
    const Eigen::Vector2d p(x, y);
    const bool has_room =
        std::ranges::all_of(edges, [&](const planning::Edge& e) { return planning::Distance(e, p) > 0.5; });
    if (has_room && planning::Contains(building, p))
      return {DrawUniform(stream, -std::numbers::pi, std::numbers::pi), p};
  }
}

/// The whole decision: raster, ways, candidates, gains, and the second round around the best; and steps 4
/// to 6 of Sec. 4.2 alone: candidates, gains, choice.
PlanningTimes MeasurePlanning(const PlanningTimeOptions& options, int candidates, int pieces) {
  const planning::LabelledPolygon building = PiecedBuilding(pieces, 1);
  const std::span area(&building, 1);
  const std::vector<planning::Edge> edges = planning::EdgesOf(area);
  PlanningTimes times{candidates, static_cast<int>(edges.size()), {}, {}};
  planning::ViewPlannerOptions planner = options.planner;
  planner.candidates.count = candidates;
  RandomStream stream = NamedStream(1, "planning_time");
  for (int i = 0; i < options.decisions; ++i) {
    const slam::Pose2 T_map_robot = DrawRobot(building, stream);
    const auto seed = static_cast<std::uint64_t>(i);
    const Stopwatch whole;
    planning::PlanNextView(area, T_map_robot, planner, seed);
    times.whole.push_back(1e3 * whole.Seconds());
    const Stopwatch choice;
    const std::vector<slam::Polygon2> plain{planning::ToPolygon2(building)};
    planning::ChooseNextView(planning::DrawCandidates(plain, edges, planner.candidates, seed), edges,
                             T_map_robot, planner.view);
    times.choice.push_back(1e3 * choice.Seconds());
  }
  return times;
}

std::vector<std::string> TimeRow(const std::string& what, const PlanningTimes& times,
                                 const std::vector<double>& ms) {
  return {what,
          std::to_string(times.candidates),
          std::to_string(times.edges),
          std::to_string(ms.size()),
          fmt::format("{:.2f}", Median(ms)),
          fmt::format("{:.2f}", Quantile(ms, 0.99)),
          fmt::format("{:.2f}", Quantile(ms, 1.0))};
}

/// Medians and 99 % of the whole decisions over what is varied.
std::string GrowthPlot(std::span<const PlanningTimes> measured, int PlanningTimes::*varied,
                       const PlanningTimeOptions& options, const std::string& title) {
  std::vector<LogSeries> series{{"whole decision, median", {}},
                                {"whole decision, 99 %", {}},
                                {"candidates and gain alone, median", {}}};
  for (const PlanningTimes& times : measured) {
    const auto x = static_cast<double>(times.*varied);
    series[0].points.emplace_back(x, Median(times.whole));
    series[1].points.emplace_back(x, Quantile(times.whole, 0.99));
    series[2].points.emplace_back(x, Median(times.choice));
  }
  const std::vector<LogLevel> levels{{fmt::format("goal for {} candidates and {} edges: median",
                                                  options.usual_candidates, options.usual_edges),
                                      options.median_limit},
                                     {"goal: 99 %", options.quantile_limit}};
  return LogPlot(series, levels, title, "planning the next view [ms]");
}

std::string Verdict(const char* what, double ms, double limit) {
  return fmt::format("{} {:.1f} ms, {} {:.0f} ms\n", what, ms, ms <= limit ? "within" : "MORE THAN", limit);
}

}  // namespace

void CheckPlanningTime(const PlanningTimeOptions& options) {
  CountsIn(options.candidates, "candidates");
  CountsIn(options.edges, "edges");
}

std::string RunPlanningTime(const PlanningTimeOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress) {
  WriteManifest(run, {});
  Table table{{"what", "candidates", "edges", "decisions", "median ms", "99 % ms", "max ms"}, {}};
  const auto measure = [&](int candidates, int edges) {
    progress.Show(fmt::format("{} candidates, {} edges", candidates, edges));
    PlanningTimes times = MeasurePlanning(options, candidates, edges);
    table.rows.push_back(TimeRow("whole decision", times, times.whole));
    table.rows.push_back(TimeRow("candidates and gain", times, times.choice));
    return times;
  };
  const PlanningTimes usual = measure(options.usual_candidates, options.usual_edges);
  std::vector<PlanningTimes> by_candidates, by_edges;
  for (const int n : CountsIn(options.candidates, "candidates"))
    by_candidates.push_back(measure(n, options.usual_edges));
  for (const int n : CountsIn(options.edges, "edges"))
    by_edges.push_back(measure(options.usual_candidates, n));
  run.WriteText("figures/time_by_candidates.svg",
                GrowthPlot(by_candidates, &PlanningTimes::candidates, options, "candidates"));
  run.WriteText("figures/time_by_edges.svg",
                GrowthPlot(by_edges, &PlanningTimes::edges, options, "edges of the known area"));
  run.WriteCsv("timing.csv", table);
  FinishRun(run, "Planning time over candidates and edges", table.rows.size());
  return fmt::format("{}\n{} candidates, {} edges: {}{}", ToText(table), usual.candidates, usual.edges,
                     Verdict("median", Median(usual.whole), options.median_limit),
                     Verdict("99 %", Quantile(usual.whole, 0.99), options.quantile_limit));
}

}  // namespace ariadne::experiments
