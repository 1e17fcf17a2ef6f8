#include "experiments/studies/explore_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/viewer.h"
#include "experiments/studies/explore_pictures.h"
#include "slam/io/file.h"
#include "slam/io/ply.h"
#include "slam/io/svg.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_pose.h"
#include "slam/map/surface_model.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kStopMark = 0.4;  // length of the mark at a scan [m]

Eigen::Vector3d Flat(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

slam::DrawingLayer MissionLayer(const std::string& name, const slam::Rgb& color) {
  slam::DrawingLayer layer;
  layer.name = name;
  layer.color = color;
  return layer;
}

/// A small arrow head where a robot stands.
slam::Polyline3 StopMark(const Pose2& T_world_base) {
  return {{Flat(T_world_base * Eigen::Vector2d(-0.5 * kStopMark, 0.25 * kStopMark)),
           Flat(T_world_base * Eigen::Vector2d(0.5 * kStopMark, 0.0)),
           Flat(T_world_base * Eigen::Vector2d(-0.5 * kStopMark, -0.25 * kStopMark))},
          true};
}

void WriteMissionTrajectory(const RunDirectory& run, const std::string& name,
                            const std::vector<slam::Pose3>& poses, const std::vector<MissionStop>& stops) {
  std::vector<slam::StampedPose> stamped;
  for (std::size_t i = 0; i < poses.size(); ++i) stamped.push_back({stops[i].time, poses[i]});
  slam::WriteFileAtomically(run.File(name), [&](std::ostream& out) { slam::WriteTum(out, stamped); });
}

/// What could have been mapped and is not, in the world's frame: where a longer mission would have gone.
void WriteMissed(const MissionVerdict& verdict, const RunDirectory& run) {
  slam::WriteFileAtomically(run.File("missed.ply"), [&](std::ostream& out) {
    slam::PlyWriter writer(out, slam::PlyEncoding::kBinary, {}, verdict.missed_world.size());
    slam::PointCloud missed_world;
    missed_world.positions = verdict.missed_world;
    writer.Add(missed_world);
    writer.Finish();
  });
}

Json CollisionsJson(const SimulatedMission& mission) {
  Json collisions = Json::array();
  for (const drivers::Collision& collision : mission.collisions) {
    collisions.push_back({{"time_s", collision.time},
                          {"thing", collision.thing},
                          {"true_x_m", collision.T_map_base.translation.x()},
                          {"true_y_m", collision.T_map_base.translation.y()}});
  }
  return collisions;
}

std::string CollisionLines(const SimulatedMission& mission) {
  std::string lines;
  for (const drivers::Collision& collision : mission.collisions) {
    const auto stop =
        std::ranges::lower_bound(mission.mission.stops, collision.time, {}, &MissionStop::time);
    lines += fmt::format(
        "on the way to scan {} it touched \"{}\", {:.0f} s after its start, at ({:.2f}, {:.2f}) m\n",
        stop - mission.mission.stops.begin(), collision.thing, collision.time,
        collision.T_map_base.translation.x(), collision.T_map_base.translation.y());
  }
  return lines;
}

/// As ariadne map, export and plan look for them.
void WriteExploredPoses(const MissionResult& result, const RunDirectory& run) {
  std::vector<slam::NamedPose> named;
  for (const slam::PosedCloud& scan : result.scans) {
    named.push_back({scan.name, scan.T_map_laser});
    slam::WriteFileAtomically(run.File("scans/" + scan.name + ".pose"),
                              [&](std::ostream& out) { slam::WriteUosPose(out, scan.T_map_laser); });
  }
  slam::WriteFileAtomically(run.File("poses.txt"),
                            [&](std::ostream& out) { slam::WritePoseList(out, named); });
}

void WriteExploredMap(const MissionResult& result, const RunDirectory& run) {
  std::size_t points = 0;
  for (const slam::PosedCloud& scan : result.scans) points += scan.cloud_laser.size();
  slam::WriteFileAtomically(run.File("map.ply"), [&](std::ostream& out) {
    const bool reflectance = !result.scans.front().cloud_laser.reflectance.empty();
    slam::PlyWriter writer(out, slam::PlyEncoding::kBinary,
                           {.reflectance = reflectance, .scan_index = true}, points);
    std::int32_t index = 0;
    for (const slam::PosedCloud& scan : result.scans)
      writer.Add(slam::Transformed(scan.T_map_laser, scan.cloud_laser), {{}, index++});
    writer.Finish();
  });
}

}  // namespace

std::string StopLine(std::size_t index, const MissionStop& stop, const TrueStop* truth) {
  const std::string drive = stop.drive == DriveEnd::kBlocked ? ", gave up: " + stop.reason
                            : stop.of_disc                   ? ", by the way of a disc"
                                                             : "";
  const std::string covered =
      truth == nullptr ? "" : fmt::format(" {:5.1f} % of the walls,", 100.0 * truth->covered);
  const slam::Pose2 shift = stop.T_map_base_guess.Inverse() * stop.T_map_base;
  const std::string registered =
      stop.registered ? fmt::format("registered {:.1f} cm off", 100.0 * shift.translation.norm())
                      : "NOT REGISTERED: " + stop.message;
  return fmt::format("scan {:3}: {:5.0f} s, {:4.0f} m,{} {}, {:.0f} m unseen, {} views left?{}", index,
                     stop.time, truth == nullptr ? stop.distance : truth->path, covered, registered,
                     stop.unseen, stop.views_left, drive);
}

Table StopTable(const SimulatedMission& mission) {
  Table table{
      {"time_s",  "distance_m", "path_m",    "covered",    "mapped",    "gain",           "registered",
       "blocked", "leg_only",   "of_disc",   "collisions", "true_x_m",  "true_y_m",       "true_angle_rad",
       "x_m",     "y_m",        "angle_rad", "guess_x_m",  "guess_y_m", "guess_angle_rad"},
      {}};
  for (std::size_t i = 0; i < mission.truth.size(); ++i) {
    const MissionStop& stop = mission.mission.stops[i];
    const TrueStop& truth = mission.truth[i];
    std::vector<std::string> row;
    const auto flag = [](bool value) { return value ? 1.0 : 0.0; };
    for (const double value :
         {stop.time, stop.distance, truth.path, truth.covered, truth.mapped,
          stop.view ? static_cast<double>(stop.view->gain) : 0.0, flag(stop.registered),
          flag(stop.drive == DriveEnd::kBlocked), flag(stop.leg_only), flag(stop.of_disc),
          static_cast<double>(truth.collisions)}) {
      row.push_back(Exact(value));
    }
    const Pose2& T_world_map = mission.T_world_map;
    for (const Pose2& pose :
         {truth.T_world_base, T_world_map * stop.T_map_base, T_world_map * stop.T_map_base_guess}) {
      for (const double value : {pose.translation.x(), pose.translation.y(), pose.angle})
        row.push_back(Exact(value));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table StopTable(const MissionResult& mission) {
  Table table{{"time_s", "distance_m", "gain", "registered", "blocked", "leg_only", "of_disc", "x_m", "y_m",
               "angle_rad", "guess_x_m", "guess_y_m", "guess_angle_rad"},
              {}};
  const auto flag = [](bool value) { return value ? 1.0 : 0.0; };
  for (const MissionStop& stop : mission.stops) {
    std::vector<std::string> row;
    for (const double value :
         {stop.time, stop.distance, stop.view ? static_cast<double>(stop.view->gain) : 0.0,
          flag(stop.registered), flag(stop.drive == DriveEnd::kBlocked), flag(stop.leg_only),
          flag(stop.of_disc), stop.T_map_base.translation.x(), stop.T_map_base.translation.y(),
          stop.T_map_base.angle, stop.T_map_base_guess.translation.x(),
          stop.T_map_base_guess.translation.y(), stop.T_map_base_guess.angle})
      row.push_back(Exact(value));
    table.rows.push_back(std::move(row));
  }
  return table;
}

slam::Drawing DrawMission(const SimulatedMission& mission, const Floor& floor) {
  slam::DrawingLayer walls = MissionLayer("walls_true", {200, 200, 200}),
                     seen = MissionLayer("seen", {0, 0, 0});
  slam::DrawingLayer unseen = MissionLayer("unseen", {220, 40, 40}),
                     path = MissionLayer("path_true", {40, 90, 220});
  slam::DrawingLayer stops = MissionLayer("scans_true", {40, 90, 220}),
                     stops_map = MissionLayer("scans", {0, 150, 80});
  slam::DrawingLayer obstacles = MissionLayer("obstacles", {200, 140, 40});
  const Pose2& T_world_map = mission.T_world_map;
  for (const FloorWall& face : floor.faces)
    walls.lines.push_back({{Flat(face.from), Flat(face.to)}, false});
  for (const planning::Edge& edge : planning::EdgesOf(mission.mission.area))
    (edge.seen ? seen : unseen)
        .lines.push_back({{Flat(T_world_map * edge.from), Flat(T_world_map * edge.to)}, false});
  for (const Eigen::Vector2d& p_map : mission.mission.obstacles_map)
    obstacles.points.push_back(Flat(T_world_map * p_map));
  slam::Polyline3 way;
  for (const Eigen::Vector2d& p : mission.path_world) way.points.push_back(Flat(p));
  if (way.points.size() > 1) path.lines.push_back(std::move(way));
  for (std::size_t i = 0; i < mission.truth.size(); ++i) {
    stops.lines.push_back(StopMark(mission.truth[i].T_world_base));
    stops_map.lines.push_back(StopMark(T_world_map * mission.mission.stops[i].T_map_base));
  }
  return {{std::move(walls), std::move(obstacles), std::move(seen), std::move(unseen), std::move(path),
           std::move(stops), std::move(stops_map)}};
}

PageSection ExplorationView(const SimulatedMission& mission, const BuildingModel& model) {
  const MissionResult& result = mission.mission;
  ViewerScene scene;
  ViewerPath driven;
  for (const Eigen::Vector2d& p_map : result.path_map) driven.points_map.push_back(Flat(p_map));
  for (std::size_t i = 0; i < result.scans.size(); ++i) AddScan(scene, result.scans[i], i);
  const std::size_t last = result.scans.size() - 1;
  for (const slam::ObjectBox& object : model.surfaces.objects)
    scene.boxes.push_back({object.box, {}, last});
  scene.mesh_map = model.mesh;
  if (driven.points_map.size() > 1) scene.driven.push_back(std::move(driven));
  for (const planning::LabelledPolygon& polygon : result.area)
    scene.polygons.push_back({polygon, 1.5, last});
  PageSection section = ViewerSection(scene, "The model in 3D");
  section.html += StepsHtml(result.stops.size());
  return section;
}

std::string ReportExploration(const SimulatedMission& mission, const MissionWorld& world,
                              const RunDirectory& run, const Parallel& parallel) {
  const MissionResult& result = mission.mission;
  run.WriteCsv("stops.csv", StopTable(mission));
  slam::WriteSvg(run.File("exploration.svg"), DrawMission(mission, world.floor.floor));
  WriteExploredPoses(result, run);
  WriteExploredMap(result, run);
  std::vector<slam::Pose3> T_map_laser;
  for (const slam::PosedCloud& scan : result.scans) T_map_laser.push_back(scan.T_map_laser);
  WriteMissionTrajectory(run, "trajectory.tum", T_map_laser, result.stops);
  WriteMissionTrajectory(run, "truth.tum", mission.T_world_laser, result.stops);
  const MissionVerdict verdict = JudgeMission(result.scans, mission.T_world_laser, world, parallel);
  WriteMissed(verdict, run);
  const auto refused = std::ranges::count(result.registered, false);
  run.WriteJson("metrics.json", {{"end", Describe(result.end)},
                                 {"scans", result.scans.size()},
                                 {"time_s", result.time},
                                 {"path_m", mission.truth.back().path},
                                 {"covered", mission.truth.back().covered},
                                 {"mapped", mission.truth.back().mapped},
                                 {"surface_covered", verdict.surface_covered},
                                 {"translation_rms_m", verdict.translation_rms},
                                 {"translation_max_m", verdict.translation_max},
                                 {"rotation_rms_rad", verdict.rotation_rms},
                                 {"map_error_median_m", verdict.map_error_median},
                                 {"map_error_mean_m", verdict.map_error_mean},
                                 {"map_error_95_m", verdict.map_error_95},
                                 {"refused", refused},
                                 {"collisions", CollisionsJson(mission)}});
  return fmt::format(
             "{} scans, {:.0f} m, {:.0f} min: {}\n{:.1f} % of the walls seen, {:.1f} % of the surface "
             "mapped; "
             "poses within "
             "{:.1f} cm (rms), map within {:.1f} mm (mean); {} scans not registered, {} contacts\n",
             result.scans.size(), mission.truth.back().path, result.time / 60.0, Describe(result.end),
             100.0 * mission.truth.back().covered, 100.0 * verdict.surface_covered,
             100.0 * verdict.translation_rms, 1000.0 * verdict.map_error_mean, refused,
             mission.collisions.size()) +
         CollisionLines(mission);
}

std::string ReportUnjudged(const MissionResult& result, const RunDirectory& run) {
  run.WriteCsv("stops.csv", StopTable(result));
  SimulatedMission as_driven;
  as_driven.mission = result;
  as_driven.path_world = result.path_map;
  slam::WriteSvg(run.File("exploration.svg"), DrawMission(as_driven, {}));
  WriteExploredPoses(result, run);
  WriteExploredMap(result, run);
  std::vector<slam::Pose3> T_map_laser;
  for (const slam::PosedCloud& scan : result.scans) T_map_laser.push_back(scan.T_map_laser);
  WriteMissionTrajectory(run, "trajectory.tum", T_map_laser, result.stops);
  const auto refused = std::ranges::count(result.registered, false);
  run.WriteJson("metrics.json", {{"end", Describe(result.end)},
                                 {"scans", result.scans.size()},
                                 {"time_s", result.time},
                                 {"distance_m", result.distance},
                                 {"unseen_m", result.stops.back().unseen},
                                 {"free_area_m2", result.stops.back().free_area},
                                 {"refused", refused}});
  return fmt::format(
      "{} scans, {:.0f} m, {:.0f} min: {}\n{:.0f} m2 known to be free; {} scans not registered\n",
      result.scans.size(), result.distance, result.time / 60.0, Describe(result.end),
      result.stops.back().free_area, refused);
}

}  // namespace ariadne::experiments
