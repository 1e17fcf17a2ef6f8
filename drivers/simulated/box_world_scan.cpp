#include "drivers/simulated/box_world_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ariadne::drivers {

slam::Scan ScanBoxWorld(const BoxWorld& world, const slam::Pose3& T_map_laser,
                        const BoxScanSettings& settings, RandomStream& range_noise) {
  slam::Scan scan;
  scan.scanner.angle_step = std::numbers::pi / (settings.beams - 1);
  scan.scanner.turns_per_sweep = std::max(1, (settings.beams - 1) / 180);
  const double sweep_duration = scan.scanner.turn_period * scan.scanner.turns_per_sweep;
  const double step = (settings.highest_pitch - settings.lowest_pitch) / settings.slices;
  for (int s = 0; s < settings.slices; ++s) {
    slam::LaserSweep sweep;
    sweep.stamp = s * sweep_duration;
    sweep.pitch = settings.lowest_pitch + s * step;
    sweep.pitch_rate = step / sweep_duration;
    for (int b = 0; b < settings.beams; ++b) {
      const auto beam = static_cast<std::size_t>(b);
      const double pitch = sweep.pitch + sweep.pitch_rate * slam::BeamTime(scan.scanner, beam);
      const Eigen::Vector3d direction =
          T_map_laser.rotation * slam::BeamDirection(scan.scanner, beam, pitch);
      const std::optional<double> distance = CastRay(world, T_map_laser.translation, direction);
      const double noise =
          DrawNormal(range_noise, 0.0, settings.range_sigma);  // drawn for every beam alike
      const bool returned = distance && *distance < settings.max_range;
      sweep.ranges.push_back(returned ? static_cast<float>(*distance + noise)
                                      : slam::LaserSweep::kNoReturn);
    }
    scan.sweeps.push_back(std::move(sweep));
  }
  return scan;
}

}  // namespace ariadne::drivers
