#include "experiments/exploration/scan_loop_world.h"

#include "experiments/metrics/map_error.h"
#include "experiments/metrics/reachable.h"
#include "experiments/metrics/trajectory_error.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kMapErrorThinning = 7;  // of a scan's points; not a divisor of 181, so no stripes

std::vector<Eigen::Vector3d> MapPoints(const Exploration3d& exploration, std::size_t thinning) {
  std::vector<Eigen::Vector3d> points_map;
  for (const slam::PosedCloud& scan : exploration.scans) {
    for (std::size_t i = 0; i < scan.cloud_laser.size(); i += thinning)
      points_map.push_back(scan.T_map_laser * scan.cloud_laser.positions[i]);
  }
  return points_map;
}

}  // namespace

ScanLoopWorld PrepareScanLoopWorld(drivers::World world, const Explore3dOptions& explore,
                                   const ScanLoopWorldOptions& options, const Parallel& parallel) {
  ScanLoopWorld prepared;
  prepared.surface = std::make_shared<drivers::SurfaceDistance>(world);
  prepared.floor.floor = CutFloor(world, options.height);
  prepared.scene = std::make_shared<drivers::RayScene>(std::move(world));
  ReachableOptions reach;
  reach.radius = options.reach_radius;
  reach.step = options.reach_step;
  const std::vector<Eigen::Vector3d> places = ReachablePlaces(*prepared.scene, reach);
  std::vector<Eigen::Vector2d> places_map;
  for (const Eigen::Vector3d& place : places) places_map.emplace_back(place.head<2>());
  prepared.floor.cover =
      FindFloorCover(prepared.floor.floor, places_map, explore.scanner, options.cover, parallel);
  VisibleSurfaceOptions visible;
  visible.max_range = explore.scanner.max_range;
  visible.lowest_elevation = explore.robot.ais.lowest_pitch;
  visible.highest_elevation = explore.robot.ais.highest_pitch;
  prepared.visible = FindVisibleSurface(
      *prepared.scene, ViewpointsAbove(places, options.cover.place_spacing, explore.robot.ais.mount_z),
      visible, parallel);
  return prepared;
}

ScanLoopVerdict JudgeExploration(const Exploration3d& exploration, const ScanLoopWorld& world,
                                 const Parallel& parallel) {
  ScanLoopVerdict verdict;
  Trajectory T_map_laser;
  for (const slam::PosedCloud& scan : exploration.scans) T_map_laser.push_back(scan.T_map_laser);
  if (T_map_laser.size() > 1) {
    const TrajectoryError error = ErrorFromMaster(T_map_laser, exploration.T_map_laser_true);
    verdict.translation_rms = error.translation.rms;
    verdict.translation_max = error.translation.max;
    verdict.rotation_rms = error.rotation.rms;
  }
  const slam::Pose3 T_world_map = PlaceByMaster(T_map_laser.front(), exploration.T_map_laser_true.front());
  verdict.surface_covered =
      MeasureCoverage(MapPoints(exploration, 1), T_world_map, world.visible, {}, parallel).share;
  const MapError map =
      MeasureMapError(MapPoints(exploration, kMapErrorThinning), T_world_map, *world.surface, {}, parallel);
  verdict.map_error_mean = map.mean;
  verdict.map_error_95 = map.percentile_95;
  return verdict;
}

}  // namespace ariadne::experiments
