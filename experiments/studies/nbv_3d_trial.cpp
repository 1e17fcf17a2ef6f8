#include "experiments/studies/nbv_3d_trial.h"

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kRobotMark = 0.4;  // length of the mark at a scan [m]

Eigen::Vector3d OnFloor(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

slam::DrawingLayer ExplorationLayer(const std::string& name, const slam::Rgb& color) {
  slam::DrawingLayer layer;
  layer.name = name;
  layer.color = color;
  return layer;
}

void AppendAreaEdges(std::span<const planning::LabelledPolygon> area, slam::DrawingLayer& seen,
                     slam::DrawingLayer& unseen) {
  for (const planning::Edge& edge : planning::EdgesOf(area))
    (edge.seen ? seen : unseen).lines.push_back({{OnFloor(edge.from), OnFloor(edge.to)}, false});
}

/// A small arrow head where a robot stands.
slam::Polyline3 RobotMark(const slam::Pose2& T_map_base) {
  return {{OnFloor(T_map_base * Eigen::Vector2d(-0.5 * kRobotMark, 0.25 * kRobotMark)),
           OnFloor(T_map_base * Eigen::Vector2d(0.5 * kRobotMark, 0.0)),
           OnFloor(T_map_base * Eigen::Vector2d(-0.5 * kRobotMark, -0.25 * kRobotMark))},
          true};
}

}  // namespace

Nbv3dTrial SummarizeTrial(const Exploration3d& exploration, const ScanLoopVerdict& verdict, double target) {
  Nbv3dTrial trial;
  const auto& steps = exploration.steps;
  trial.scans = static_cast<double>(steps.size());
  trial.path = steps.back().path;
  trial.target_scans = ScansTo(exploration, target);
  trial.target_path = PathTo(exploration, target);
  trial.covered = steps.back().covered;
  trial.mapped = steps.back().mapped;
  trial.verdict = verdict;
  trial.ended = exploration.ended ? 1.0 : 0.0;
  trial.refused = exploration.refused;
  trial.collisions = exploration.collisions;
  for (const RobotScanStep& step : steps) {
    trial.planning_seconds += step.planning_seconds / trial.scans;
    trial.matching_seconds += step.matching_seconds / trial.scans;
  }
  return trial;
}

Table Nbv3dTrialTable(const std::vector<Nbv3dTrial>& trials) {
  Table table{{"world", "planner", "seed", "scans", "path_m", "target_scans", "target_path_m", "covered",
               "mapped", "surface_covered", "translation_rms_m", "translation_max_m", "rotation_rms_rad",
               "map_error_mean_m", "map_error_95_m", "ended", "refused", "collisions"},
              {}};
  for (const Nbv3dTrial& t : trials) {
    const ScanLoopVerdict& v = t.verdict;
    std::vector<std::string> row{t.world, t.planner, std::to_string(t.seed)};
    for (const double value : {t.scans, t.path, t.target_scans, t.target_path, t.covered, t.mapped,
                               v.surface_covered, v.translation_rms, v.translation_max, v.rotation_rms,
                               v.map_error_mean, v.map_error_95, t.ended, t.refused, t.collisions}) {
      row.push_back(Exact(value));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table RobotStepTable(const Exploration3d& exploration) {
  Table table{{"path_m", "covered", "mapped", "gain", "registered", "blocked", "true_x_m", "true_y_m",
               "true_angle_rad", "x_m", "y_m", "angle_rad", "guess_x_m", "guess_y_m", "guess_angle_rad"},
              {}};
  for (const RobotScanStep& step : exploration.steps) {
    std::vector<std::string> row;
    for (const double value : {step.path, step.covered, step.mapped, static_cast<double>(step.gain),
                               step.registered ? 1.0 : 0.0, step.blocked ? 1.0 : 0.0}) {
      row.push_back(Exact(value));
    }
    for (const slam::Pose2& pose : {step.T_map_base_true, step.T_map_base, step.T_map_base_guess}) {
      for (const double value : {pose.translation.x(), pose.translation.y(), pose.angle})
        row.push_back(Exact(value));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

slam::Drawing DrawExploration(const Exploration3d& exploration, const Floor& floor) {
  slam::DrawingLayer walls = ExplorationLayer("walls_true", {200, 200, 200}),
                     seen = ExplorationLayer("seen", {0, 0, 0});
  slam::DrawingLayer unseen = ExplorationLayer("unseen", {220, 40, 40}),
                     path = ExplorationLayer("path_true", {40, 90, 220});
  slam::DrawingLayer stops = ExplorationLayer("scans_true", {40, 90, 220}),
                     stops_map = ExplorationLayer("scans", {0, 150, 80});
  for (const FloorWall& face : floor.faces)
    walls.lines.push_back({{OnFloor(face.from), OnFloor(face.to)}, false});
  AppendAreaEdges(exploration.area, seen, unseen);
  slam::Polyline3 way;
  for (const Eigen::Vector2d& p : exploration.path_map_true) way.points.push_back(OnFloor(p));
  if (way.points.size() > 1) path.lines.push_back(std::move(way));
  for (const RobotScanStep& step : exploration.steps) {
    stops.lines.push_back(RobotMark(step.T_map_base_true));
    stops_map.lines.push_back(RobotMark(step.T_map_base));
  }
  return {{std::move(walls), std::move(seen), std::move(unseen), std::move(path), std::move(stops),
           std::move(stops_map)}};
}

}  // namespace ariadne::experiments
