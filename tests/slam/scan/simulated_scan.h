#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "slam/geometry/angles.h"
#include "slam/scan/scan.h"

/// The scanner of the paper (Sec. 2.2; spec 9.2) in a box-shaped room, for the tests of slam/scan.
namespace ariadne::slam {

/// 181, 361 or 721 beams over 180 deg, measured in 1, 2 or 4 turns of the mirror.
inline ScannerModel ScannerWithTurns(int turns) {
  ScannerModel scanner;
  scanner.angle_step = RadFromDeg(1.0 / turns);
  scanner.turns_per_sweep = turns;
  return scanner;
}

inline std::size_t BeamsOf(const ScannerModel& scanner) {
  return static_cast<std::size_t>(std::lround(std::numbers::pi / scanner.angle_step)) + 1;
}

/// The direction of a beam, by turning the slice plane about the y axis: independent of BeamDirection.
inline Eigen::Vector3d DirectionByRotation(double angle, double pitch) {
  return Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()) *
         Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0.0);
}

/// From the laser to the walls of the room -2 < x < 6, -1.5 < y < 2.5, -0.5 < z < 2. [m]
inline double RangeInRoom(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d low(-2.0, -1.5, -0.5);
  const Eigen::Vector3d high(6.0, 2.5, 2.0);
  double range = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (direction[k] > 0.0) range = std::min(range, high[k] / direction[k]);
    if (direction[k] < 0.0) range = std::min(range, low[k] / direction[k]);
  }
  return range;
}

/// Sweeps from 40 deg below the horizon upwards, `step_deg` apart, while the servo runs on.
inline Scan ScanOfRoom(int turns, int sweeps, double step_deg = 120.0 / 128.0) {
  Scan scan;
  scan.scanner = ScannerWithTurns(turns);
  const double sweep_time = turns * scan.scanner.turn_period;
  for (int s = 0; s < sweeps; ++s) {
    LaserSweep sweep;
    sweep.stamp = s * sweep_time;
    sweep.pitch = RadFromDeg(-40.0 + s * step_deg);
    sweep.pitch_rate = RadFromDeg(step_deg) / sweep_time;
    for (std::size_t beam = 0; beam < BeamsOf(scan.scanner); ++beam) {
      const double degrees = static_cast<double>(beam) / turns;
      const double passed =
          (static_cast<int>(beam) % turns + degrees / 360.0) / turns;  // of the sweep's time
      const Eigen::Vector3d direction =
          DirectionByRotation(RadFromDeg(degrees), RadFromDeg(-40.0 + (s + passed) * step_deg));
      sweep.ranges.push_back(static_cast<float>(RangeInRoom(direction)));
    }
    scan.sweeps.push_back(sweep);
  }
  return scan;
}

/// A scan at pitch 0 with the given ranges and reflectances, sweep by sweep.
inline Scan ScanWith(const std::vector<std::vector<float>>& ranges,
                     const std::vector<std::vector<float>>& reflectances) {
  Scan scan;
  scan.scanner = ScannerWithTurns(1);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    scan.sweeps.emplace_back();
    scan.sweeps.back().ranges = ranges[s];
    scan.sweeps.back().reflectance = reflectances[s];
  }
  return scan;
}

}  // namespace ariadne::slam
