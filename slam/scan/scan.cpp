#include "slam/scan/scan.h"

#include <cmath>
#include <numbers>

namespace ariadne::slam {

double BeamTime(const ScannerModel& scanner, std::size_t beam) {
  const double angle = scanner.first_angle + static_cast<double>(beam) * scanner.angle_step;
  const auto turn = static_cast<double>(beam % static_cast<std::size_t>(scanner.turns_per_sweep));
  return scanner.turn_period * (turn + angle / (2.0 * std::numbers::pi));
}

Eigen::Vector3d BeamDirection(const ScannerModel& scanner, std::size_t beam, double pitch) {
  const double angle = scanner.first_angle + static_cast<double>(beam) * scanner.angle_step;
  return {std::sin(angle) * std::cos(pitch), -std::cos(angle), std::sin(angle) * std::sin(pitch)};
}

PointCloud ToPointCloud(const Scan& scan) {
  PointCloud cloud;
  for (const LaserSweep& sweep : scan.sweeps) {
    cloud.slice_begin.push_back(cloud.size());
    for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
      if (!std::isfinite(sweep.ranges[beam])) continue;
      const double pitch = sweep.pitch + sweep.pitch_rate * BeamTime(scan.scanner, beam);
      cloud.positions.push_back(static_cast<double>(sweep.ranges[beam]) *
                                BeamDirection(scan.scanner, beam, pitch));
      if (!sweep.reflectance.empty()) cloud.reflectance.push_back(sweep.reflectance[beam]);
    }
  }
  if (cloud.reflectance.size() != cloud.size()) cloud.reflectance.clear();  // not every sweep has it
  return cloud;
}

}  // namespace ariadne::slam
