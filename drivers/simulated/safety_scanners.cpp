#include "drivers/simulated/safety_scanners.h"

#include <fmt/format.h>

#include <numbers>

#include "drivers/simulated/range_finder.h"
#include "drivers/simulated/sweep_beams.h"

namespace ariadne::drivers {
namespace {

SweepMounting MountingAt(double x, double heading, const SafetyScannerOptions& options) {
  const int turns = options.half_degree ? 2 : 1;
  SweepMounting mounting;
  mounting.T_base_laser = slam::ToPose3(slam::Pose2{heading, {x, 0.0}});
  mounting.T_base_laser.translation.z() = options.height;
  mounting.scanner = HalfCircle(turns);
  mounting.beams = HalfCircleBeams(turns);
  return mounting;
}

}  // namespace

std::vector<SafetySweep> TakeSafetySweeps(const RayScene& scene, const Motion& T_map_base,
                                          double start_time, const SafetyScannerOptions& options,
                                          std::uint64_t seed, std::uint64_t sweep_number) {
  CheckOptions(options, "safety.");
  if (!options.installed) return {};
  const auto take = [&](std::string name, double x, double heading) -> SafetySweep {
    const SweepMounting mounting = MountingAt(x, heading, options);
    const RangeFinder device(std::move(name), options.range_finder, seed);
    const auto beams = SweepBeams(mounting, T_map_base, start_time, 0.0, 0.0);
    slam::LaserSweep sweep = device.Measure(scene, beams, fmt::format("sweep/{}", sweep_number));
    sweep.stamp = start_time;
    return {mounting.T_base_laser, mounting.scanner, std::move(sweep)};
  };
  return {take("safety_front", options.front_x, 0.0),
          take("safety_rear", options.rear_x, std::numbers::pi)};
}

}  // namespace ariadne::drivers
