#include "experiments/mission/mission_world.h"

#include "experiments/metrics/map_error.h"
#include "experiments/metrics/reachable.h"
#include "experiments/metrics/trajectory_error.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kMapErrorThinning = 7;  // of a scan's points; not a divisor of 181, so no stripes

std::vector<Eigen::Vector3d> MapPoints(std::span<const slam::PosedCloud> scans_map, std::size_t thinning) {
  std::vector<Eigen::Vector3d> points_map;
  for (const slam::PosedCloud& scan : scans_map) {
    for (std::size_t i = 0; i < scan.cloud_laser.size(); i += thinning)
      points_map.push_back(scan.T_map_laser * scan.cloud_laser.positions[i]);
  }
  return points_map;
}

}  // namespace

MissionWorld PrepareMissionWorld(drivers::World world, const drivers::SimulatedRobotOptions& robot,
                                 const FloorScannerOptions& scanner, const MissionWorldOptions& options,
                                 const Parallel& parallel) {
  MissionWorld prepared;
  prepared.surface = std::make_shared<drivers::SurfaceDistance>(world);
  prepared.floor.floor = CutFloor(world, options.height);
  prepared.scene = std::make_shared<drivers::RayScene>(std::move(world));
  ReachableOptions reach;
  reach.radius = options.reach_radius;
  reach.step = options.reach_step;
  const std::vector<Eigen::Vector3d> places = ReachablePlaces(*prepared.scene, reach);
  std::vector<Eigen::Vector2d> places_map;
  for (const Eigen::Vector3d& place : places) places_map.emplace_back(place.head<2>());
  prepared.floor.cover = FindFloorCover(prepared.floor.floor, places_map, scanner, options.cover, parallel);
  VisibleSurfaceOptions visible;
  visible.max_range = scanner.max_range;
  visible.lowest_elevation = robot.ais.lowest_pitch;
  visible.highest_elevation = robot.ais.highest_pitch;
  prepared.visible = FindVisibleSurface(
      *prepared.scene, ViewpointsAbove(places, options.cover.place_spacing, robot.ais.mount_z), visible,
      parallel);
  return prepared;
}

MissionVerdict JudgeMission(std::span<const slam::PosedCloud> scans_map,
                            const std::vector<slam::Pose3>& T_world_laser, const MissionWorld& world,
                            const Parallel& parallel) {
  MissionVerdict verdict;
  Trajectory T_map_laser;
  for (const slam::PosedCloud& scan : scans_map) T_map_laser.push_back(scan.T_map_laser);
  if (T_map_laser.size() > 1) {
    const TrajectoryError error = ErrorFromMaster(T_map_laser, T_world_laser);
    verdict.translation_rms = error.translation.rms;
    verdict.translation_max = error.translation.max;
    verdict.rotation_rms = error.rotation.rms;
  }
  const slam::Pose3 T_world_map = PlaceByMaster(T_map_laser.front(), T_world_laser.front());
  Coverage coverage = MeasureCoverage(MapPoints(scans_map, 1), T_world_map, world.visible, {}, parallel);
  verdict.surface_covered = coverage.share;
  verdict.missed_world = std::move(coverage.missed_world);
  const MapError map =
      MeasureMapError(MapPoints(scans_map, kMapErrorThinning), T_world_map, *world.surface, {}, parallel);
  verdict.map_error_median = map.median;
  verdict.map_error_mean = map.mean;
  verdict.map_error_95 = map.percentile_95;
  return verdict;
}

}  // namespace ariadne::experiments
