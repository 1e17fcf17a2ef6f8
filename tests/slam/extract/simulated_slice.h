#pragma once

#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "experiments/metrics/line_detection.h"
#include "slam/extract/slice_points.h"
#include "tests/drivers/simulated/box_room.h"
#include "tests/support/random_room.h"

/// Slices of random rooms with all errors of the scanner, and the walls that are in them.
namespace ariadne::slam {

using experiments::TrueWall;

struct SimulatedSlice {
  std::vector<Eigen::Vector2d> points;
  std::vector<TrueWall> surfaces;  // all that two beams or more meet in succession, less than 0.5 m apart

  /// Those that a detector should find.
  std::vector<TrueWall> Walls() const {
    std::vector<TrueWall> walls = surfaces;
    std::erase_if(walls, [](const TrueWall& wall) { return !IsToBeFound(wall); });
    return walls;
  }
};

inline drivers::RayScene SceneOf(const Room& room) {
  drivers::World world;
  for (const Box3& solid : room.world.solids) {
    world.bodies.push_back(drivers::BoxBody("solid", solid.min(), solid.max()));
  }
  return drivers::RayScene(std::move(world));
}

/// A horizontal sweep from a random place in a random room.
inline SimulatedSlice SimulateSlice(std::uint64_t seed, const drivers::AisScannerOptions& options = {}) {
  RandomStream stream = NamedStream(seed, "simulated_slice");
  const Room room = DrawRoom(stream);
  const Eigen::Vector3d viewpoint_map = DrawViewpoint(stream, room);
  const double heading = DrawUniform(stream, -3.0, 3.0);
  Pose3 T_map_base = ToPose3({heading, Eigen::Vector2d::Zero()});
  const drivers::SweepMounting mounting = AisMounting(options);
  T_map_base.translation = viewpoint_map - T_map_base * mounting.T_base_laser.translation;
  const drivers::RayScene scene = SceneOf(room);
  const drivers::Motion standing = drivers::Standing(T_map_base);
  const LaserSweep sweep = TakeAisSweep(scene, standing, 0.0, options, seed, 0);
  const std::vector<drivers::Ray> beams = SweepBeams(mounting, standing, 0.0, 0.0, 0.0);
  return {SlicePoints(mounting.scanner, sweep),
          experiments::VisibleWalls(scene, beams, mounting.scanner, T_map_base.rotation)};
}

}  // namespace ariadne::slam
