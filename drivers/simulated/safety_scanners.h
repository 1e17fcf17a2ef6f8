#pragma once

#include <vector>

#include "drivers/robot.h"
#include "drivers/simulated/range_finder_options.h"
#include "drivers/simulated/ray_scene.h"

namespace ariadne::drivers {

/// The two 2D scanners that stand in for bumpers, front and rear, each 180 deg horizontal (Sec. 2.1). Model
/// and height are open.
struct SafetyScannerOptions {
  bool installed = true;
  double front_x = 0.40;
  double rear_x = -0.40;
  double height = 0.20;
  bool half_degree = true;
  RangeFinderOptions range_finder;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("installed", self.installed, "whether the robot has them");
    visit("front_x", self.front_x, Unit("m"), Range{-10.0, 10.0},
          "the front one, ahead of the middle of the driven wheels; at the end of a platform of 80 cm");
    visit("rear_x", self.rear_x, Unit("m"), Range{-10.0, 10.0}, "the rear one, which looks backwards");
    visit("height", self.height, Unit("m"), Range{0.0, 10.0},
          "above the floor; open, so low that legs, skirtings and pallets are seen");
    visit("half_degree", self.half_degree, "361 points in 26.7 ms, else 181 in 13.3 ms");
    visit("range_finder", self.range_finder, "both devices; open, of the same make as the one of the AIS");
  }
};

/// What both see from `start_time` on [s], front first; none where they are not installed. `T_map_base` is
/// the base's way: it may drive meanwhile. `sweep_number` tells the sweeps of a run apart and names the
/// streams of noise.
std::vector<SafetySweep> TakeSafetySweeps(const RayScene& scene, const Motion& T_map_base,
                                          double start_time, const SafetyScannerOptions& options,
                                          std::uint64_t seed, std::uint64_t sweep_number);

}  // namespace ariadne::drivers
