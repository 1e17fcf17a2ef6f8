#include "experiments/studies/mission_trial.h"

#include <algorithm>

namespace ariadne::experiments {

MissionTrial SummarizeMission(const SimulatedMission& mission, const MissionVerdict& verdict,
                              double target) {
  MissionTrial trial;
  const auto& stops = mission.mission.stops;
  trial.end = mission.mission.end;
  trial.scans = static_cast<double>(stops.size());
  trial.path = mission.truth.back().path;
  trial.minutes = mission.mission.time / 60.0;
  trial.target_scans = StopsTo(mission, target);
  trial.target_path = WayTo(mission, target);
  trial.covered = mission.truth.back().covered;
  trial.mapped = mission.truth.back().mapped;
  trial.verdict = verdict;
  trial.ended = trial.end == MissionEnd::kNothingLeft ? 1.0 : 0.0;
  trial.refused = static_cast<double>(std::ranges::count(mission.mission.registered, false));
  trial.blocked = static_cast<double>(std::ranges::count(stops, DriveEnd::kBlocked, &MissionStop::drive));
  trial.collisions = static_cast<double>(mission.collisions.size());
  for (const MissionStop& stop : stops) {
    trial.planning_seconds += stop.planning_seconds / trial.scans;
    trial.matching_seconds += stop.matching_seconds / trial.scans;
  }
  return trial;
}

Table MissionTrialTable(const std::vector<MissionTrial>& trials) {
  Table table{{"world",
               "way",
               "seed",
               "end",
               "scans",
               "path_m",
               "minutes",
               "target_scans",
               "target_path_m",
               "covered",
               "mapped",
               "surface_covered",
               "translation_rms_m",
               "translation_max_m",
               "rotation_rms_rad",
               "map_error_median_m",
               "map_error_mean_m",
               "map_error_95_m",
               "refused",
               "blocked",
               "collisions"},
              {}};
  for (const MissionTrial& t : trials) {
    const MissionVerdict& v = t.verdict;
    std::vector<std::string> row{t.world, t.way, std::to_string(t.seed), std::string(Describe(t.end))};
    for (const double value :
         {t.scans, t.path, t.minutes, t.target_scans, t.target_path, t.covered, t.mapped, v.surface_covered,
          v.translation_rms, v.translation_max, v.rotation_rms, v.map_error_median, v.map_error_mean,
          v.map_error_95, t.refused, t.blocked, t.collisions}) {
      row.push_back(Exact(value));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json MissionTrialTimes(const std::vector<MissionTrial>& trials) {
  Json json = Json::array();
  for (const MissionTrial& t : trials) {
    json.push_back({{"world", t.world},
                    {"way", t.way},
                    {"seed", t.seed},
                    {"planning_seconds_per_scan", t.planning_seconds},
                    {"matching_seconds_per_scan", t.matching_seconds}});
  }
  return json;
}

}  // namespace ariadne::experiments
