#include "experiments/studies/register_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/metrics/residuals.h"
#include "experiments/metrics/trajectory_error.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

/// The table of the run, with times and in handy units.
Table SummaryTable(const RegisterLog& log, const std::vector<double>& match_seconds) {
  Table table{{"scan", "name", "partner", "pairs", "overlap %", "rms cm", "moved cm", "moved deg",
               "alignments", "time ms", "registered"},
              {}};
  for (std::size_t i = 0; i < log.scans.rows.size(); ++i) {
    const std::vector<std::string>& row = log.scans.rows[i];
    const auto number = [&](std::size_t column) { return std::stod(row[column]); };
    table.rows.push_back({row[0], row[1], row[3].empty() ? "-" : row[3], row[4], Percent(number(5)),
                          fmt::format("{:.2f}", 100.0 * number(6)),
                          fmt::format("{:.1f}", 100.0 * number(8)),
                          fmt::format("{:.2f}", slam::DegFromRad(number(9))), row[10],
                          fmt::format("{:.0f}", 1e3 * match_seconds[i]), row[2]});
  }
  return table;
}

Table ResidualTable(const std::vector<ResidualChange>& residuals) {
  Table table{
      {"model", "data", "pairs_before", "median_before_m", "plane_median_before_m", "plane_rms_before_m",
       "pairs_after", "median_after_m", "plane_median_after_m", "plane_rms_after_m"},
      {}};
  for (const ResidualChange& r : residuals) {
    table.rows.push_back({std::to_string(r.model), std::to_string(r.data)});
    for (const PairResidual& residual : {r.before, r.after}) {
      for (const std::string& cell : {std::to_string(residual.pairs), Exact(residual.median),
                                      Exact(residual.plane_median), Exact(residual.plane_rms)}) {
        table.rows.back().push_back(cell);
      }
    }
  }
  return table;
}

/// The median over the pairs of scans of their median distances to the other's surface. [m]
double MedianPlaneDistance(const std::vector<ResidualChange>& residuals,
                           PairResidual ResidualChange::*when) {
  std::vector<double> medians;
  for (const ResidualChange& r : residuals) medians.push_back((r.*when).plane_median);
  if (medians.empty()) return 0.0;
  const auto middle = medians.begin() + static_cast<std::ptrdiff_t>(medians.size() / 2);
  std::nth_element(medians.begin(), middle, medians.end());
  return *middle;
}

/// The errors against the truth before and after; null where it is not known.
Json TruthMetrics(const ScanSource& source, const RegisterLog& log) {
  std::vector<slam::Pose3> truth, odometry;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (!source.truth(i)) return nullptr;
    truth.push_back(*source.truth(i));
    odometry.push_back(source.T_odom_laser(i));
  }
  const auto errors = [&](const std::vector<slam::Pose3>& poses) {
    const TrajectoryError e = ErrorFromMaster(poses, truth);
    return Json{{"translation_rms_m", e.translation.rms},
                {"translation_max_m", e.translation.max},
                {"rotation_rms_rad", e.rotation.rms},
                {"rotation_max_rad", e.rotation.max}};
  };
  return {{"odometry", errors(odometry)}, {"map", errors(log.T_map_laser)}};
}

std::size_t CountAccepted(const RegisterLog& log) {
  return static_cast<std::size_t>(
      std::ranges::count_if(log.closures.rows, [](const auto& row) { return row[8] == "yes"; }));
}

std::string ErrorSentence(const Json& truth) {
  if (truth.is_null()) return "";
  const auto cm = [&](const char* which) {
    return 100.0 * truth[which]["translation_rms_m"].get<double>();
  };
  const auto deg = [&](const char* which) {
    return slam::DegFromRad(truth[which]["rotation_rms_rad"].get<double>());
  };
  return fmt::format(
      "error against the truth, rms: odometry {:.1f} cm and {:.2f} deg, map {:.2f} cm and {:.3f} deg",
      cm("odometry"), deg("odometry"), cm("map"), deg("map"));
}

}  // namespace

std::string RegisterSummary::Problem() const {
  if (unregistered == 0) return "";
  return fmt::format("{} of {} scans could not be registered; scans.csv says why", unregistered, scans);
}

RegisterSummary ReportRegistration(const RegisterOptions& options, const ScanSource& source,
                                   const slam::Mapper& mapper, const RegisterLog& log,
                                   const std::vector<double>& match_seconds, const RunDirectory& run) {
  std::vector<slam::Pose3> T_odom_laser;
  for (std::size_t i = 0; i < source.size(); ++i) T_odom_laser.push_back(source.T_odom_laser(i));
  const slam::AlignOptions& icp = options.mapper.icp;
  const ResidualOptions residual_options{
      static_cast<std::size_t>(options.mapper.registration.overlap_pairs),
      std::max(icp.max_distance, icp.start_distance)};
  const std::vector<ResidualChange> residuals =
      MeasureResiduals(mapper.scans(), T_odom_laser, residual_options, Parallel(icp.threads));
  const double before = MedianPlaneDistance(residuals, &ResidualChange::before);
  const double after = MedianPlaneDistance(residuals, &ResidualChange::after);
  const Json truth = TruthMetrics(source, log);
  RegisterSummary summary{SummaryTable(log, match_seconds), source.size(), 0, "", ErrorSentence(truth)};
  summary.unregistered =
      static_cast<std::size_t>(std::count(log.registered.begin(), log.registered.end(), false));
  summary.residuals = fmt::format(
      "distance of a scan's points to the surface of another, median over {} overlapping pairs: {:.2f} cm "
      "before, {:.2f} cm after",
      residuals.size(), 100.0 * before, 100.0 * after);
  if (!log.closures.rows.empty()) {
    summary.residuals += fmt::format("\nclosures of loops: {} tried, {} accepted; closures.csv says why",
                                     log.closures.rows.size(), CountAccepted(log));
  }
  run.WriteCsv("residuals.csv", ResidualTable(residuals));
  run.WriteJson("metrics.json", {{"scans", summary.scans},
                                 {"registered", summary.scans - summary.unregistered},
                                 {"alignments", log.steps.rows.size()},
                                 {"closures_tried", log.closures.rows.size()},
                                 {"closures", CountAccepted(log)},
                                 {"passes", log.passes.rows.size()},
                                 {"overlapping_pairs", residuals.size()},
                                 {"median_plane_distance_before_m", before},
                                 {"median_plane_distance_after_m", after},
                                 {"errors", truth}});
  return summary;
}

}  // namespace ariadne::experiments
