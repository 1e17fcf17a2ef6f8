#include "experiments/studies/ablation_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/metrics/nees.h"
#include "experiments/metrics/statistics.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/graph_trials.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

std::uint64_t Seed(int k) { return static_cast<std::uint64_t>(k) + 1; }

/// The trials in groups of those that have the same labels, in the order of their first appearance.
template <typename Trial, typename Same>
std::vector<std::vector<Trial>> Grouped(const std::vector<Trial>& trials, const Same& same) {
  std::vector<std::vector<Trial>> groups;
  for (const Trial& trial : trials) {
    const auto group = std::ranges::find_if(groups, [&](const auto& g) { return same(g.front(), trial); });
    if (group == groups.end()) {
      groups.push_back({trial});
    } else {
      group->push_back(trial);
    }
  }
  return groups;
}

template <typename Trial, typename Value>
std::vector<double> Each(const std::vector<Trial>& trials, const Value& value) {
  std::vector<double> values;
  for (const Trial& trial : trials) values.push_back(static_cast<double>(value(trial)));
  return values;
}

std::string MedianText(const std::vector<double>& values, double per_unit,
                       const BootstrapOptions& bootstrap) {
  const Interval i = BootstrapInterval(values, MedianStatistic, bootstrap);
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", per_unit * i.estimate, per_unit * i.low, per_unit * i.high);
}

Table KernelTable(const std::vector<RobustTrial>& trials, const BootstrapOptions& bootstrap) {
  Table table{
      {"wrong %", "kernel", "position cm", "clean cm", "within 2x %", "wrong kept %", "right rejected %"},
      {}};
  const auto same = [](const RobustTrial& a, const RobustTrial& b) {
    return a.wrong_share == b.wrong_share && a.kernel == b.kernel;
  };
  for (const auto& group : Grouped(trials, same)) {
    ClosureVerdicts sum;
    for (const RobustTrial& t : group) {
      sum.wrong += t.verdicts.wrong;
      sum.wrong_kept += t.verdicts.wrong_kept;
      sum.right += t.verdicts.right;
      sum.right_rejected += t.verdicts.right_rejected;
    }
    const auto share = [](std::size_t part, std::size_t all) {
      return all == 0 ? std::string("-") : Percent(static_cast<double>(part) / static_cast<double>(all));
    };
    table.rows.push_back(
        {Percent(group.front().wrong_share), group.front().kernel,
         MedianText(Each(group, [](const auto& t) { return t.position_rms; }), 100.0, bootstrap),
         fmt::format("{:.2f}", 100.0 * Median(Each(group, [](const auto& t) { return t.reference_rms; }))),
         Percent(Mean(
             Each(group, [](const auto& t) { return t.position_rms <= 2.0 * t.reference_rms ? 1 : 0; }))),
         share(sum.wrong_kept, sum.wrong), share(sum.right_rejected, sum.right)});
  }
  return table;
}

Table StartTable(const std::vector<StartTrial>& trials, const BootstrapOptions& bootstrap) {
  Table table{{"noise", "start", "certified %", "factorizations", "position cm", "mean NEES", "95 % band"},
              {}};
  const auto same = [](const StartTrial& a, const StartTrial& b) {
    return a.noise == b.noise && a.start == b.start;
  };
  for (const auto& group : Grouped(trials, same)) {
    const NeesBand band = MeanNeesBand(group.size());
    table.rows.push_back(
        {Exact(group.front().noise), group.front().start,
         Percent(Mean(Each(group, [](const auto& t) { return t.certified ? 1 : 0; }))),
         fmt::format("{:.0f}", Median(Each(group, [](const auto& t) { return t.factorizations; }))),
         MedianText(Each(group, [](const auto& t) { return t.position_rms; }), 100.0, bootstrap),
         fmt::format("{:.2f}", Mean(Each(group, [](const auto& t) { return t.nees; }))),
         fmt::format("{:.2f} to {:.2f}", band.low, band.high)});
  }
  return table;
}

Table SizeTable(const std::vector<SizeTrial>& trials) {
  Table table{{"poses", "edges", "factor kB"}, {}};
  for (const auto& group : Grouped(trials, [](const auto&a, const auto&b) { return a.poses == b.poses; })) {
    table.rows.push_back(
        {std::to_string(group.front().poses),
         fmt::format("{:.0f}", Median(Each(group, [](const auto& t) { return t.edges; }))),
         fmt::format("{:.1f}", 1e-3 * Median(Each(group, [](const auto& t) { return t.factor_bytes; })))});
  }
  return table;
}

/// The same groups' times, which are not deterministic: for timing.json and to print.
Table SizeTimeTable(const std::vector<SizeTrial>& trials) {
  Table table{{"poses", "optimize ms", "certify ms", "covariances ms"}, {}};
  for (const auto& group : Grouped(trials, [](const auto&a, const auto&b) { return a.poses == b.poses; })) {
    const auto ms = [&](double SizeTrial::*seconds) {
      return fmt::format("{:.2f}", 1e3 * Median(Each(group, [&](const auto& t) { return t.*seconds; })));
    };
    table.rows.push_back({std::to_string(group.front().poses), ms(&SizeTrial::optimize_seconds),
                          ms(&SizeTrial::certify_seconds), ms(&SizeTrial::covariance_seconds)});
  }
  return table;
}

Json TimesAsJson(const Table& times) {
  Json json = Json::array();
  for (const auto& row : times.rows) {
    Json entry;
    for (std::size_t c = 0; c < row.size(); ++c) entry[times.columns[c]] = std::stod(row[c]);
    json.push_back(entry);
  }
  return json;
}

/// Runs `make(level, seed)` for all levels and seeds and puts all trials in a row.
template <typename Trial, typename Make>
std::vector<Trial> ForAll(const std::string& what, const std::vector<double>& levels, int seeds,
                          ProgressDisplay& progress, const Make& make) {
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (int k = 0; k < seeds; ++k) {
      const double done =
          (static_cast<double>(i) + static_cast<double>(k) / seeds) / static_cast<double>(levels.size());
      progress.Show(
          fmt::format("{} {}, seed {} of {}, {:.0f} %", what, levels[i], k + 1, seeds, 100.0 * done));
      for (Trial& trial : make(levels[i], Seed(k))) trials.push_back(std::move(trial));
    }
    progress.Keep(fmt::format("{} {}: {} graphs", what, levels[i], seeds));
  }
  return trials;
}

std::string Report(const AblationGraphOptions& options, const std::vector<RobustTrial>& kernels,
                   const std::vector<StartTrial>& starts, const std::vector<SizeTrial>& sizes,
                   const RunDirectory& run) {
  const Table times = SizeTimeTable(sizes);
  std::string text;
  const auto keep = [&](const std::string& name, const std::string& heading, const Table& table) {
    run.WriteCsv(name + ".csv", table);
    run.WriteText(name + ".tex", ToLatex(table));
    text += heading + "\n" + ToText(table) + "\n";
  };
  keep("kernels", "robust kernels against wrong closures (medians with intervals)",
       KernelTable(kernels, options.bootstrap));
  keep("starts", "starts against noise", StartTable(starts, options.bootstrap));
  keep("sizes", "what graphs of some size cost", SizeTable(sizes));
  run.WriteJson("timing.json", TimesAsJson(times));
  return text + ToText(times);
}

}  // namespace

void CheckAblationGraph(const AblationGraphOptions& options) {
  ParseNumbers(options.wrong_shares, "wrong_shares");
  ParseNumbers(options.noise_levels, "noise_levels");
  ParseNumbers(options.sizes, "sizes");
}

std::string RunAblationGraph(const AblationGraphOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress) {
  const auto shares = ParseNumbers(options.wrong_shares, "wrong_shares");
  const auto levels = ParseNumbers(options.noise_levels, "noise_levels");
  const auto sizes = ParseNumbers(options.sizes, "sizes");
  WriteManifest(run, {});
  run.WriteProgress("running", 0, 3);
  const auto kernels = ForAll<RobustTrial>("wrong closures", shares, options.seeds, progress,
                                           [&](double share, std::uint64_t seed) {
                                             return TryKernels(options.walk, options.graph, share, seed);
                                           });
  run.WriteProgress("running", 1, 3);
  const auto starts =
      ForAll<StartTrial>("noise", levels, options.seeds, progress, [&](double noise, std::uint64_t seed) {
        return TryStarts(options.walk, options.graph, noise, seed);
      });
  run.WriteProgress("running", 2, 3);
  const auto costs =
      ForAll<SizeTrial>("poses", sizes, options.seeds, progress, [&](double poses, std::uint64_t seed) {
        return std::vector{TrySize(options.walk, options.graph, static_cast<int>(poses), seed)};
      });
  std::string text = Report(options, kernels, starts, costs, run);
  FinishRun(run, "Pose graphs: kernels, starts, sizes", 3);
  return text;
}

}  // namespace ariadne::experiments
