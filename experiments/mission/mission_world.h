#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drivers/simulated/simulated_robot.h"
#include "drivers/simulated/surface_distance.h"
#include "experiments/exploration/floor_cover.h"
#include "experiments/metrics/coverage.h"

namespace ariadne::experiments {

/// A world to explore in space, and what is needed to judge how it went; made once per world.
struct MissionWorld {
  std::shared_ptr<const drivers::RayScene> scene;
  FloorToExplore floor;
  VisibleSurface visible;
  std::shared_ptr<const drivers::SurfaceDistance> surface;
};

struct MissionWorldOptions {
  double height = 1.5;
  double reach_radius = 0.35;
  double reach_step = 0.1;
  FloorCoverOptions cover;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{0.0, 10.0}, "of the floor whose walls are to be seen");
    visit("reach_radius", self.reach_radius, Unit("m"), Range{0.05, 2.0},
          "free around a place that counts as reachable, at the robot's own heights, furniture included");
    visit("reach_step", self.reach_step, Unit("m"), Range{0.01, 1.0}, "of the grid of such places");
    visit("cover", self.cover, "which places on walls are to be seen; its radius is not used");
  }
};

/// What can be seen from where the robot can be: the walls of the floor by the scanner of the plane, and
/// all surfaces by the tilted scanner of the robot.
MissionWorld PrepareMissionWorld(drivers::World world, const drivers::SimulatedRobotOptions& robot,
                                 const FloorScannerOptions& scanner, const MissionWorldOptions& options,
                                 const Parallel& parallel);

/// How an exploration went, against the truth.
struct MissionVerdict {
  double surface_covered = 0.0;   // share of the visible surface with a point of the map within 10 cm
  double translation_rms = 0.0;   // of the scans' poses, from the master (ErrorFromMaster) [m]
  double rotation_rms = 0.0;      // [rad]
  double translation_max = 0.0;   // [m]
  double map_error_median = 0.0;  // of the points, to the nearest true surface [m]
  double map_error_mean = 0.0;    // [m]
  double map_error_95 = 0.0;      // [m]
  std::vector<Eigen::Vector3d> missed_world;  // points of the visible surface without a point of the map
};

/// The scans where they came to lie, and where the scanner truly was; at least one.
MissionVerdict JudgeMission(std::span<const slam::PosedCloud> scans_map,
                            const std::vector<slam::Pose3>& T_world_laser, const MissionWorld& world,
                            const Parallel& parallel);

}  // namespace ariadne::experiments
