#pragma once

#include <vector>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"
#include "drivers/simulated/tour.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// Scans of a robot that is driven through a building that is known exactly.
struct TourOptions {
  std::string world = "builtin:robobench";
  std::string waypoints = "1.5 -0.08, 34.2 -0.08";
  double spacing = 1.7;
  int scans = 20;
  double odometry_noise = 1.0;
  int seed = 1;
  drivers::AisScannerOptions scanner;
  drivers::SimulatedBaseOptions base;
  drivers::WorldOptions geometry;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("world", self.world,
          "builtin:robobench, builtin:entrance_hall, a description (.yaml), a floor plan "
          "(.json) or a mesh; $ARIADNE_DATA stands for the environment's");
    visit("waypoints", self.waypoints,
          "of the way: x y, x y, ... [m]; the first stop is at the first; the default goes down the "
          "corridor, a "
          "little to the right of its middle, clear of the jutting table");
    visit("spacing", self.spacing, Unit("m"), Range{0.01, 100.0},
          "between stops along the way; 20 of 1.7 m are the corridor of Fig. 4");
    visit("scans", self.scans, Unit(""), Range{1, 100000}, "at most; Fig. 4 has 20");
    visit("odometry_noise", self.odometry_noise, Unit(""), Range{0.0, 1000.0},
          "factor on the random errors of the wheels, and on what the odometry takes them for");
    visit("seed", self.seed, Unit(""), Range{0, 2147483647}, "of all errors");
    visit("scanner", self.scanner, "the AIS 3D scanner");
    visit("base", self.base, "the mobile base");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
  }
};

/// The stops of a tour, and the scan at each, which is cast when it is asked for.
class SimulatedTour {
 public:
  explicit SimulatedTour(const TourOptions& options);

  std::size_t size() const { return stops_.size(); }
  slam::Pose3 T_map_laser_true(std::size_t i) const;
  /// By odometry alone, from the true first pose on.
  slam::Pose3 T_odom_laser(std::size_t i) const;
  /// With the odometry at the stop.
  slam::Scan TakeScan(std::size_t i, const Parallel& parallel) const;

  const drivers::RayScene& scene() const { return scene_; }
  const std::vector<drivers::TourStop>& stops() const { return stops_; }

 private:
  SimulatedTour(const TourOptions& options, drivers::World world);

  TourOptions options_;
  slam::Pose3 T_base_laser_;
  drivers::RayScene scene_;
  std::vector<drivers::TourStop> stops_;
};

}  // namespace ariadne::experiments
