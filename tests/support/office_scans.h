#pragma once

#include <string>
#include <vector>

#include "drivers/simulated/box_world_scan.h"
#include "slam/geometry/angles.h"
#include "slam/matching/map_scan.h"
#include "slam/reduce/reduce.h"
#include "tests/support/random_geometry.h"

/// Coarse scans of the simulated office, for tests that match many.
namespace ariadne::slam {

inline PointCloud ScanOffice(const Pose3& T_map_laser, std::uint64_t seed) {
  static const drivers::BoxWorld office = drivers::MakeOffice();
  RandomStream noise = NamedStream(seed, "office_scans/range");
  drivers::BoxScanSettings settings;
  settings.beams = 91;
  settings.slices = 64;
  return ReduceVoxels(ToPointCloud(ScanBoxWorld(office, T_map_laser, settings, noise)), 0.1);
}

/// The laser at a stop of the tour, a metre above the floor.
inline Pose3 LaserAt(const Pose2& stop) {
  Pose3 T_map_laser = ToPose3(stop);
  T_map_laser.translation.z() = 1.0;
  return T_map_laser;
}

inline MapScan ScanAt(const Pose3& T_map_laser, std::uint64_t seed) {
  const PointCloud points = ScanOffice(T_map_laser, seed);
  return {"scan" + std::to_string(seed), points, KdTree(points.positions), T_map_laser, false};
}

/// The scans of the tour at their true poses, none registered.
inline std::vector<MapScan> ScanTour() {
  std::vector<MapScan> scans;
  for (const Pose2& stop : drivers::OfficeTour()) scans.push_back(ScanAt(LaserAt(stop), scans.size()));
  return scans;
}

}  // namespace ariadne::slam
