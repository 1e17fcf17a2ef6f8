#include "experiments/studies/matching_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "experiments/metrics/hypothesis_test.h"
#include "experiments/metrics/statistics.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using Values = std::vector<double>;

/// What is looked at, in the unit of the tables.
struct Measure {
  const char* name;
  double MatchingTrial::*value;
  double per_unit;
};

constexpr std::array<Measure, 6> kMeasures{
    {{"position cm", &MatchingTrial::translation_rms, 100.0},
     {"rotation deg", &MatchingTrial::rotation_rms, slam::DegFromRad(1.0)},
     {"map error cm", &MatchingTrial::map_error_mean, 100.0},
     {"wall cm", &MatchingTrial::wall_median, 100.0},
     {"worst wall cm", &MatchingTrial::wall_worst, 100.0},
     {"NEES", &MatchingTrial::nees, 1.0}}};

constexpr std::size_t kErrors = 5;  // the first ones; the smaller, the better

/// The values without repetitions, in the order of their first appearance.
template <typename T>
std::vector<T> Distinct(const std::vector<LabelledTrial>& trials, T LabelledTrial::*label) {
  std::vector<T> distinct;
  for (const LabelledTrial& t : trials) {
    if (std::ranges::find(distinct, t.*label) == distinct.end()) distinct.push_back(t.*label);
  }
  return distinct;
}

Values Select(const std::vector<LabelledTrial>& trials, double noise, const std::string& method,
              const Measure& measure) {
  Values values;
  for (const LabelledTrial& t : trials) {
    if (t.noise == noise && t.method == method)
      values.push_back(measure.per_unit * (t.trial.*measure.value));
  }
  return values;
}

std::string ToText(const Interval& i) {
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", i.estimate, i.low, i.high);
}

/// Only a method that tells covariances has a NEES.
bool HasCovariances(const Values& nees) {
  return std::ranges::any_of(nees, [](double value) { return value > 0.0; });
}

}  // namespace

Table TrialTable(const std::vector<LabelledTrial>& trials) {
  Table table{{"odometry_noise", "seed", "method", "registered", "translation_rms_m", "rotation_rms_rad",
               "map_error_mean_m", "map_error_95_m", "share_within_2cm", "wall_median_m", "wall_worst_m",
               "nees_position"},
              {}};
  for (const LabelledTrial& t : trials) {
    table.rows.push_back(
        {Exact(t.noise), std::to_string(t.seed), t.method, std::to_string(t.trial.registered)});
    for (const double value :
         {t.trial.translation_rms, t.trial.rotation_rms, t.trial.map_error_mean, t.trial.map_error_95,
          t.trial.share_within_2cm, t.trial.wall_median, t.trial.wall_worst, t.trial.nees}) {
      table.rows.back().push_back(Exact(value));
    }
  }
  return table;
}

Table MedianTable(const std::vector<LabelledTrial>& trials, const BootstrapOptions& bootstrap) {
  Table table{{"noise", "method"}, {}};
  for (const Measure& measure : kMeasures) table.columns.push_back(measure.name);
  for (const double noise : Distinct(trials, &LabelledTrial::noise)) {
    for (const std::string& method : Distinct(trials, &LabelledTrial::method)) {
      table.rows.push_back({Exact(noise), method});
      for (const Measure& measure : kMeasures) {
        const Values values = Select(trials, noise, method, measure);
        const bool unknown = measure.value == &MatchingTrial::nees && !HasCovariances(values);
        table.rows.back().push_back(
            unknown ? "-" : ToText(BootstrapInterval(values, MedianStatistic, bootstrap)));
      }
    }
  }
  return table;
}

Table PairedTable(const std::vector<LabelledTrial>& trials, const std::string& reference,
                  const BootstrapOptions& bootstrap) {
  Table table{{"noise", "method", "against", "measure", "median difference", "p (Holm)"}, {}};
  Values p_values;
  for (const double noise : Distinct(trials, &LabelledTrial::noise)) {
    for (const std::string& method : Distinct(trials, &LabelledTrial::method)) {
      if (method == reference || method == "truth" || method == "odometry") continue;
      for (const Measure& measure : std::span(kMeasures).first(kErrors)) {
        const Values a = Select(trials, noise, method, measure);
        const Values b = Select(trials, noise, reference, measure);
        p_values.push_back(TestSignedRank(a, b).p_two_sided);
        table.rows.push_back({Exact(noise), method, reference, measure.name,
                              ToText(BootstrapDifference(a, b, MedianStatistic, bootstrap))});
      }
    }
  }
  const Values adjusted = HolmAdjusted(p_values);
  for (std::size_t i = 0; i < adjusted.size(); ++i)
    table.rows[i].push_back(fmt::format("{:.2g}", adjusted[i]));
  return table;
}

Json ToJson(const LabelledTrial& t) {
  return {{"noise", t.noise},
          {"seed", t.seed},
          {"method", t.method},
          {"registered", t.trial.registered},
          {"translation_rms", t.trial.translation_rms},
          {"rotation_rms", t.trial.rotation_rms},
          {"map_error_mean", t.trial.map_error_mean},
          {"map_error_95", t.trial.map_error_95},
          {"share_within_2cm", t.trial.share_within_2cm},
          {"wall_median", t.trial.wall_median},
          {"wall_worst", t.trial.wall_worst},
          {"nees", t.trial.nees},
          {"seconds", t.trial.seconds}};
}

LabelledTrial LabelledTrialFromJson(const Json& json) {
  LabelledTrial t{json.at("noise"), json.at("seed"), json.at("method"), {}};
  t.trial.registered = json.at("registered");
  t.trial.translation_rms = json.at("translation_rms");
  t.trial.rotation_rms = json.at("rotation_rms");
  t.trial.map_error_mean = json.at("map_error_mean");
  t.trial.map_error_95 = json.at("map_error_95");
  t.trial.share_within_2cm = json.at("share_within_2cm");
  t.trial.wall_median = json.at("wall_median");
  t.trial.wall_worst = json.at("wall_worst");
  t.trial.nees = json.at("nees");
  t.trial.seconds = json.at("seconds");
  return t;
}

}  // namespace ariadne::experiments
