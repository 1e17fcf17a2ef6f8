#include "experiments/studies/mission_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/metrics/statistics.h"

namespace ariadne::experiments {
namespace {

using MissionTrials = std::vector<MissionTrial>;

std::vector<double> EachMission(const MissionTrials& trials,
                                const std::function<double(const MissionTrial&)>& value) {
  std::vector<double> values;
  for (const MissionTrial& trial : trials) values.push_back(value(trial));
  return values;
}

/// Trials that share a text, in the order of their first appearance.
std::vector<MissionTrials> MissionTrialsBy(std::string MissionTrial::*text, const MissionTrials& trials) {
  std::vector<MissionTrials> groups;
  for (const MissionTrial& trial : trials) {
    const auto group = std::ranges::find_if(
        groups, [&](const MissionTrials& g) { return g.front().*text == trial.*text; });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(trial);
  }
  return groups;
}

std::string FiniteText(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string MedianWithInterval(const std::vector<double>& values, int digits,
                               const BootstrapOptions& bootstrap) {
  const Interval i = BootstrapInterval(values, MedianStatistic, bootstrap);
  return fmt::format("{} [{}, {}]", FiniteText(i.estimate, digits), FiniteText(i.low, digits),
                     FiniteText(i.high, digits));
}

double MeanMission(const MissionTrials& trials, double MissionTrial::*value) {
  return Mean(EachMission(trials, [&](const MissionTrial& t) { return t.*value; }));
}

}  // namespace

// Where the target was not reached, the number of scans is
/// infinite, which a median can bear; "-" says that it is.
Table MissionVariantTable(const MissionTrials& trials, double target, const BootstrapOptions& bootstrap) {
  Table table{
      {"mission", "runs", "reached %", fmt::format("scans to {} %", Percent(target)),
       fmt::format("way to {} % m", Percent(target)), "scans", "way m", "minutes", "walls %", "mapped %",
       "surface %", "position cm", "map mm", "refused", "given up", "collisions", "ended %"},
      {}};
  for (const MissionTrials& group : MissionTrialsBy(&MissionTrial::way, trials)) {
    const auto median = [&](double MissionTrial::*value, double per_unit, int digits) {
      return FiniteText(per_unit * Median(EachMission(group, [&](const auto& t) { return t.*value; })),
                        digits);
    };
    const auto verdict = [&](double MissionVerdict::*value, double per_unit) {
      return FiniteText(
          per_unit * Median(EachMission(group, [&](const auto& t) { return t.verdict.*value; })), 1);
    };
    const auto reached = [](const MissionTrial& t) { return std::isfinite(t.target_scans) ? 1.0 : 0.0; };
    table.rows.push_back(
        {group.front().way, std::to_string(group.size()), Percent(Mean(EachMission(group, reached))),
         MedianWithInterval(EachMission(group, [](const auto& t) { return t.target_scans; }), 1, bootstrap),
         MedianWithInterval(EachMission(group, [](const auto& t) { return t.target_path; }), 0, bootstrap),
         median(&MissionTrial::scans, 1.0, 1), median(&MissionTrial::path, 1.0, 0),
         median(&MissionTrial::minutes, 1.0, 1), median(&MissionTrial::covered, 100.0, 1),
         median(&MissionTrial::mapped, 100.0, 1), verdict(&MissionVerdict::surface_covered, 100.0),
         verdict(&MissionVerdict::translation_rms, 100.0),
         verdict(&MissionVerdict::map_error_median, 1000.0),
         fmt::format("{:.2f}", MeanMission(group, &MissionTrial::refused)),
         fmt::format("{:.1f}", MeanMission(group, &MissionTrial::blocked)),
         fmt::format("{:.2f}", MeanMission(group, &MissionTrial::collisions)),
         Percent(MeanMission(group, &MissionTrial::ended))});
  }
  return table;
}

Table MissionWorldTable(const MissionTrials& trials, double target) {
  Table table{{"world", "mission", "runs", fmt::format("scans to {} %", Percent(target)), "scans", "way m",
               "minutes", "walls %", "mapped %", "surface %", "least surface %", "position cm", "worst cm",
               "map mm", "refused", "given up", "collisions", "ended %"},
              {}};
  for (const MissionTrials& world : MissionTrialsBy(&MissionTrial::world, trials)) {
    for (const MissionTrials& group : MissionTrialsBy(&MissionTrial::way, world)) {
      const auto median = [&](const std::function<double(const MissionTrial&)>& value, int digits) {
        return FiniteText(Median(EachMission(group, value)), digits);
      };
      const auto surface = [](auto& t) { return 100.0 * t.verdict.surface_covered; };
      const auto position = [](auto& t) { return 100.0 * t.verdict.translation_rms; };
      table.rows.push_back(
          {world.front().world, group.front().way, std::to_string(group.size()),
           median([](auto& t) { return t.target_scans; }, 1), median([](auto& t) { return t.scans; }, 1),
           median([](auto& t) { return t.path; }, 0), median([](auto& t) { return t.minutes; }, 1),
           median([](auto& t) { return 100.0 * t.covered; }, 1),
           median([](auto& t) { return 100.0 * t.mapped; }, 1), median(surface, 1),
           FiniteText(std::ranges::min(EachMission(group, surface)), 1), median(position, 1),
           FiniteText(std::ranges::max(EachMission(group, position)), 1),
           median([](auto& t) { return 1000.0 * t.verdict.map_error_median; }, 1),
           fmt::format("{:.2f}", MeanMission(group, &MissionTrial::refused)),
           fmt::format("{:.1f}", MeanMission(group, &MissionTrial::blocked)),
           fmt::format("{:.2f}", MeanMission(group, &MissionTrial::collisions)),
           Percent(MeanMission(group, &MissionTrial::ended))});
    }
  }
  return table;
}

Table MissionDifferenceTable(const MissionTrials& trials, double penalty,
                             const BootstrapOptions& bootstrap) {
  Table table{{"mission", "pairs", "scans to target", "scans", "way m", "walls %", "surface %",
               "position mm", "map mm"},
              {}};
  const std::vector<MissionTrials> groups = MissionTrialsBy(&MissionTrial::way, trials);
  for (std::size_t g = 1; g < groups.size(); ++g) {
    const auto difference = [&](double per_unit, const std::function<double(const MissionTrial&)>& value) {
      const Interval i = BootstrapDifference(EachMission(groups[g], value), EachMission(groups[0], value),
                                             Mean, bootstrap);
      return fmt::format("{:+.1f} [{:+.1f}, {:+.1f}]", per_unit * i.estimate, per_unit * i.low,
                         per_unit * i.high);
    };
    table.rows.push_back(
        {groups[g].front().way + " - " + groups[0].front().way, std::to_string(groups[g].size()),
         difference(1.0, [&](auto& t) { return std::min(penalty, t.target_scans); }),
         difference(1.0, [](auto& t) { return t.scans; }), difference(1.0, [](auto& t) { return t.path; }),
         difference(100.0, [](auto& t) { return t.covered; }),
         difference(100.0, [](auto& t) { return t.verdict.surface_covered; }),
         difference(1000.0, [](auto& t) { return t.verdict.translation_rms; }),
         difference(1000.0, [](auto& t) { return t.verdict.map_error_median; })});
  }
  return table;
}

}  // namespace ariadne::experiments
