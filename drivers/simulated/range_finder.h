#pragma once

#include <span>
#include <string>
#include <string_view>

#include "drivers/simulated/range_errors.h"
#include "drivers/simulated/ray_scene.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// One simulated 2D range finder with its own systematic error. All randomness comes from streams that are
/// named after the device, the source and the sweep, and each beam draws from each of them, whether it
/// returns or not: so draws do not depend on the world, on the other sources or on threads.
class RangeFinder {
 public:
  /// `name` tells the devices of a robot apart ("ais", "safety_front").
  RangeFinder(std::string name, const RangeFinderOptions& options, std::uint64_t seed);

  const RangeFinderOptions& options() const { return options_; }

  /// What the device reports for the beams of one sweep, each cast at its own time; stamp and pitch are
  /// left to the caller. `sweep_name` is unique among the sweeps of the device ("scan/3/17").
  slam::LaserSweep Measure(const RayScene& scene, std::span<const Ray> beams,
                           std::string_view sweep_name) const;

 private:
  RandomStream Stream(std::string_view source, std::string_view sweep_name) const;

  std::string name_;
  RangeFinderOptions options_;
  std::uint64_t seed_;
  SystematicError systematic_;
};

}  // namespace ariadne::drivers
