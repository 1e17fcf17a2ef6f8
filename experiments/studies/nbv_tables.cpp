#include "experiments/studies/nbv_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/metrics/hypothesis_test.h"
#include "experiments/metrics/statistics.h"

namespace ariadne::experiments {
namespace {

using NbvValues = std::vector<double>;
using NbvMeasure = std::function<double(const NbvTrial&)>;

// Where a share was never seen, its ratio stands for infinity: it ranks last, and what is interpolated
// with it, or changed to it, counts as never too.
constexpr double kNever = 1e12, kAtLeastNever = 1e6;

std::vector<std::string> NamesIn(std::span<const NbvTrial> trials, std::string NbvTrial::*name) {
  std::vector<std::string> names;
  for (const NbvTrial& trial : trials) {
    if (std::ranges::find(names, trial.*name) == names.end()) names.push_back(trial.*name);
  }
  return names;
}

std::vector<NbvTrial> OfVariant(std::span<const NbvTrial> trials, const std::string& study,
                                const std::string& variant) {
  std::vector<NbvTrial> chosen;
  std::ranges::copy_if(trials, std::back_inserter(chosen), [&](const NbvTrial& trial) {
    return trial.study == study && trial.variant == variant;
  });
  return chosen;
}

/// The trials of `default` from the starts that a variant has been tried from.
std::vector<NbvTrial> DefaultFromStartsOf(std::span<const NbvTrial> variant,
                                          std::span<const NbvTrial> trials) {
  std::uint64_t last = 0;
  for (const NbvTrial& t : variant) last = std::max(last, t.seed);
  std::vector<NbvTrial> base = OfVariant(trials, "policies", "default");
  std::erase_if(base, [&](const NbvTrial& t) { return t.seed > last; });
  return base;
}

/// For each floor the median over its seeds.
NbvValues ByFloor(std::span<const NbvTrial> trials, const NbvMeasure& measure) {
  NbvValues medians;
  for (const std::string& floor : NamesIn(trials, &NbvTrial::floor)) {
    NbvValues values;
    for (const NbvTrial& trial : trials) {
      if (trial.floor == floor) values.push_back(std::min(measure(trial), kNever));
    }
    medians.push_back(Median(values));
  }
  return medians;
}

double ScanRatio(const NbvTrial& t) { return t.scans_95 / t.bound_scans; }
double PathRatio(const NbvTrial& t) { return t.path_95 / t.bound_path; }

double MeanOver(std::span<const NbvTrial> trials, const NbvMeasure& measure) {
  NbvValues values;
  for (const NbvTrial& trial : trials) values.push_back(measure(trial));
  return Mean(values);
}

double LeastOver(std::span<const NbvTrial> trials, const NbvMeasure& measure) {
  double least = measure(trials.front());
  for (const NbvTrial& trial : trials) least = std::min(least, measure(trial));
  return least;
}

/// A number with its interval, by `format` or as `never`.
std::string WithInterval(const NbvValues& values, const BootstrapOptions& bootstrap,
                         const std::function<std::string(double)>& format) {
  const Interval i = BootstrapInterval(values, MedianStatistic, bootstrap);
  const auto text = [&](double v) { return v >= kAtLeastNever ? std::string("never") : format(v); };
  return fmt::format("{} [{}, {}]", text(i.estimate), text(i.low), text(i.high));
}

std::string RatioText(const NbvValues& values, const BootstrapOptions& bootstrap) {
  return WithInterval(values, bootstrap, [](double v) { return fmt::format("{:.2f}", v); });
}

/// A variant beside the default, floor by floor.
struct Comparison {
  std::string change;  // in per cent, with its interval
  double p = 1.0;
};

Comparison Compare(const NbvValues& variant, const NbvValues& base, const BootstrapOptions& bootstrap) {
  NbvValues change, logs;
  for (std::size_t i = 0; i < variant.size(); ++i) {
    change.push_back(100.0 * (variant[i] / base[i] - 1.0));
    logs.push_back(std::log(variant[i] / base[i]));
  }
  return {WithInterval(change, bootstrap, [](double v) { return fmt::format("{:+.0f}", v); }),
          TestSignedRank(logs).p_two_sided};
}

std::vector<std::string> RowOf(const std::string& name, std::span<const NbvTrial> trials,
                               const BootstrapOptions& bootstrap) {
  return {
      name,
      RatioText(ByFloor(trials, ScanRatio), bootstrap),
      RatioText(ByFloor(trials, PathRatio), bootstrap),
      Percent(MeanOver(trials, [](const NbvTrial& t) { return std::isfinite(t.scans_95) ? 1.0 : 0.0; })),
      Percent(MeanOver(trials, [](const NbvTrial& t) { return t.ended ? 1.0 : 0.0; })),
      fmt::format("{:.2f}", 100.0 * Median(ByFloor(trials, [](const NbvTrial& t) { return t.covered; }))),
      fmt::format("{:.2f}", 100.0 * LeastOver(trials, [](const NbvTrial& t) { return t.covered; }))};
}

}  // namespace

Table NbvTrialTable(std::span<const NbvTrial> trials) {
  Table table{{"floor", "study", "variant", "seed", "scans", "path_m", "covered", "ended", "scans_to_share",
               "path_to_share_m", "bound_scans", "bound_tour_m"},
              {}};
  for (const NbvTrial& t : trials) {
    table.rows.push_back({t.floor, t.study, t.variant, std::to_string(t.seed), Exact(t.scans),
                          Exact(t.path), Exact(t.covered), t.ended ? "1" : "0", Exact(t.scans_95),
                          Exact(t.path_95), Exact(t.bound_scans), Exact(t.bound_path)});
  }
  return table;
}

Table NbvFloorTable(std::span<const NbvTrial> trials, std::span<const NbvFloorSummary> floors) {
  Table table{{"floor", "reachable m2", "walls m", "fewest views", "proven from", "tour m", "default scans",
               "default way m", "covered %"},
              {}};
  const std::vector<NbvTrial> base = OfVariant(trials, "policies", "default");
  for (const NbvFloorSummary& floor : floors) {
    NbvValues tours, scans, ways, covered;
    for (const NbvTrial& t : base) {
      if (t.floor != floor.name) continue;
      tours.push_back(t.bound_path);
      scans.push_back(std::min(t.scans_95, kNever));
      ways.push_back(std::min(t.path_95, kNever));
      covered.push_back(100.0 * t.covered);
    }
    const auto median = [](const NbvValues& values) {
      if (values.empty()) return std::string("-");
      const double middle = Median(values);
      return middle < kAtLeastNever ? fmt::format("{:.0f}", middle) : std::string("never");
    };
    table.rows.push_back({floor.name, fmt::format("{:.0f}", floor.reachable_area),
                          fmt::format("{:.0f}", floor.wall_length), std::to_string(floor.fewest_views),
                          std::to_string(floor.lower_bound), median(tours), median(scans), median(ways),
                          covered.empty() ? "-" : fmt::format("{:.2f}", Median(covered))});
  }
  return table;
}

Table NbvStudyTable(std::span<const NbvTrial> trials, const std::string& study,
                    const BootstrapOptions& bootstrap) {
  Table table{{study, "scans / fewest", "way / tour", "reached %", "ended %", "covered %", "least %",
               "scans, change %", "p", "way, change %", "p way"},
              {}};
  std::vector<NbvTrial> of_study;
  std::ranges::copy_if(trials, std::back_inserter(of_study),
                       [&](const NbvTrial& t) { return t.study == study; });
  if (of_study.empty()) return table;
  std::vector<double> p_scans, p_ways;
  for (const std::string& name : NamesIn(of_study, &NbvTrial::variant)) {
    const std::vector<NbvTrial> variant = OfVariant(trials, study, name);
    const std::vector<NbvTrial> base = DefaultFromStartsOf(variant, trials);
    const Comparison scans = Compare(ByFloor(variant, ScanRatio), ByFloor(base, ScanRatio), bootstrap);
    const Comparison ways = Compare(ByFloor(variant, PathRatio), ByFloor(base, PathRatio), bootstrap);
    p_scans.push_back(scans.p);
    p_ways.push_back(ways.p);
    table.rows.push_back(RowOf(name, variant, bootstrap));
    table.rows.back().insert(table.rows.back().end(), {scans.change, "", ways.change, ""});
  }
  const auto adjusted_scans = HolmAdjusted(p_scans), adjusted_ways = HolmAdjusted(p_ways);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i][8] = fmt::format("{:.2g}", adjusted_scans[i]);
    table.rows[i][10] = fmt::format("{:.2g}", adjusted_ways[i]);
  }
  return table;
}

Table NbvCurveTable(std::span<const NbvTrial> trials) {
  Table table{{"policy", "bound", "covered_by_scans", "covered_by_way"}, {}};
  for (const std::string& name : NamesIn(trials, &NbvTrial::variant)) {
    const std::vector<NbvTrial> variant = OfVariant(trials, "policies", name);
    if (variant.empty()) continue;
    for (double multiple = 0.0; multiple < 4.01; multiple += 0.1) {
      const double by_scans = MeanOver(variant, [&](const NbvTrial& t) {
        const auto scans = static_cast<std::size_t>(std::max(1.0, multiple * t.bound_scans));
        return t.covered_after[std::min(scans, t.covered_after.size()) - 1];
      });
      const double by_way = MeanOver(variant, [&](const NbvTrial& t) {
        const auto beyond = std::ranges::upper_bound(t.path_after, multiple * t.bound_path);
        return t.covered_after[static_cast<std::size_t>(beyond - t.path_after.begin()) - 1];
      });
      table.rows.push_back({name, fmt::format("{:.1f}", multiple), Exact(by_scans), Exact(by_way)});
    }
  }
  return table;
}

Table NbvTimeTable(std::span<const NbvTrial> trials) {
  Table table{{"study", "variant", "decisions", "median ms", "99 % ms", "max ms"}, {}};
  for (const std::string& study : NamesIn(trials, &NbvTrial::study)) {
    for (const std::string& name : NamesIn(trials, &NbvTrial::variant)) {
      NbvValues ms;
      for (const NbvTrial& t : OfVariant(trials, study, name)) {
        for (const double seconds : t.planning_seconds) ms.push_back(1e3 * seconds);
      }
      if (ms.empty()) continue;
      table.rows.push_back({study, name, std::to_string(ms.size()), fmt::format("{:.1f}", Median(ms)),
                            fmt::format("{:.1f}", Quantile(ms, 0.99)),
                            fmt::format("{:.1f}", Quantile(ms, 1.0))});
    }
  }
  return table;
}

}  // namespace ariadne::experiments
