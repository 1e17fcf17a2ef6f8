#include "experiments/bench/corridor_tour.h"

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"

namespace ariadne::bench {
namespace {

std::vector<TourScan> TakeTour() {
  const drivers::RayScene scene(drivers::LoadWorld("builtin:robobench"));
  const drivers::AisScannerOptions options;
  const slam::Pose3 T_base_laser = drivers::AisMounting(options).T_base_laser;
  const Parallel parallel(1);
  std::vector<TourScan> scans;
  for (double x = 1.5; x < 34.5; x += 2.0) {
    const slam::Pose3 T_map_base = slam::ToPose3({0.0, {x, -0.08}});
    const slam::Scan scan =
        drivers::TakeAisScan(scene, T_map_base, 0.0, options, 1, scans.size(), parallel);
    const slam::Pose3 T_map_laser = T_map_base * T_base_laser;
    scans.push_back({Transformed(T_map_laser, ToPointCloud(scan)), T_map_laser.translation});
  }
  return scans;
}

}  // namespace

const std::vector<TourScan>& CorridorTour() {
  static const std::vector<TourScan> kTour = TakeTour();
  return kTour;
}

}  // namespace ariadne::bench
