#include "experiments/studies/register_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "slam/geometry/pose3.h"

namespace ariadne::experiments {
namespace {

std::string Partners(const std::vector<std::size_t>& scans) {
  return fmt::format("{}", fmt::join(scans, " "));
}

std::vector<std::string> CovarianceColumns() {
  std::vector<std::string> columns{"step", "scan"};
  const std::vector<std::string> names{"x", "y", "z", "rx", "ry", "rz"};
  for (int row = 0; row < 6; ++row) {
    for (int col = row; col < 6; ++col) {
      columns.push_back(names[static_cast<std::size_t>(row)] + "_" + names[static_cast<std::size_t>(col)]);
    }
  }
  return columns;
}

std::vector<std::string> CovarianceRow(std::size_t step, std::size_t scan,
                                       const slam::Pose3::Square& covariance) {
  std::vector<std::string> row{std::to_string(step), std::to_string(scan)};
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) row.push_back(Exact(covariance(i, j)));
  }
  return row;
}

}  // namespace

RegisterLog::RegisterLog() {
  scans.columns = {"scan",  "name",       "registered", "partners",  "pairs",      "overlap",
                   "rms_m", "iterations", "moved_m",    "moved_rad", "alignments", "message"};
  steps.columns = {"step",  "scan",  "partners", "status",    "iterations",
                   "pairs", "rms_m", "moved_m",  "moved_rad", "requeued"};
  iterations.columns = {"step", "iteration", "max_distance_m", "pairs", "rms_m", "step_m", "step_rad"};
  covariances.columns = CovarianceColumns();
  closures.columns = {"from",  "to",      "status",           "pairs",    "overlap",
                      "rms_m", "moved_m", "squared_distance", "accepted", "verdict"};
  passes.columns = {"after_scan", "of",    "scans",   "links",     "pairs",
                    "iterations", "rms_m", "moved_m", "moved_rad", "settled"};
}

void RegisterLog::Add(const slam::Mapper& mapper, const slam::MatchResult& result,
                      std::size_t points_in_range, bool with_reflectance) {
  const slam::MapScan& scan = mapper.scans().back();
  const std::size_t index = mapper.scans().size() - 1;
  const slam::MatchStep none;
  const slam::MatchStep& first = result.steps.empty() ? none : result.steps.front();
  scans.rows.push_back({std::to_string(index), scan.name, result.registered ? "yes" : "no",
                        Partners(first.partners), std::to_string(first.align.pairs),
                        Exact(first.align.overlap), Exact(first.align.rms),
                        std::to_string(first.align.iterations.size()),
                        Exact(slam::TranslationDistance(result.T_map_laser_guess, scan.T_map_laser)),
                        Exact(slam::RotationDistance(result.T_map_laser_guess, scan.T_map_laser)),
                        std::to_string(result.steps.size()), result.message});
  for (const slam::MatchStep& step : result.steps) {
    const std::size_t number = steps.rows.size();
    const slam::AlignResult& align = step.align;
    steps.rows.push_back({std::to_string(number), std::to_string(step.scan), Partners(step.partners),
                          std::string(Name(align.status)), std::to_string(align.iterations.size()),
                          std::to_string(align.pairs), Exact(align.rms), Exact(step.moved_translation),
                          Exact(step.moved_rotation), Partners(step.requeued)});
    for (std::size_t k = 0; k < align.iterations.size(); ++k) {
      const slam::AlignIteration& it = align.iterations[k];
      iterations.rows.push_back({std::to_string(number), std::to_string(k + 1), Exact(it.max_distance),
                                 std::to_string(it.pairs), Exact(it.rms), Exact(it.step_translation),
                                 Exact(it.step_rotation)});
    }
    if (align.assessment)
      covariances.rows.push_back(CovarianceRow(number, step.scan, align.assessment->covariance));
  }
  AddPasses(mapper, result);
  registered.push_back(result.registered);
  points.push_back(points_in_range);
  has_reflectance = has_reflectance && with_reflectance;
}

void RegisterLog::AddFinish(const slam::Mapper& mapper, const slam::MatchResult& result) {
  AddPasses(mapper, result);
}

void RegisterLog::AddPasses(const slam::Mapper& mapper, const slam::MatchResult& result) {
  const std::string after = std::to_string(mapper.scans().size() - 1);
  for (const slam::Closure& c : result.closures) {
    closures.rows.push_back({std::to_string(c.from), std::to_string(c.to),
                             std::string(Name(c.align.status)), std::to_string(c.align.pairs),
                             Exact(c.align.overlap), Exact(c.align.rms), Exact(c.moved_translation),
                             Exact(c.squared_distance), c.accepted ? "yes" : "no", c.verdict});
  }
  for (const slam::MatchPass& p : result.passes) {
    passes.rows.push_back({after, p.of, std::to_string(p.scans), std::to_string(p.links),
                           std::to_string(p.pairs), std::to_string(p.iterations), Exact(p.rms),
                           Exact(p.moved_translation), Exact(p.moved_rotation), p.settled ? "yes" : "no"});
  }
  graph = mapper.graph();
  T_map_laser.clear();
  for (const slam::MapScan& s : mapper.scans()) T_map_laser.push_back(s.T_map_laser);
}

}  // namespace ariadne::experiments
