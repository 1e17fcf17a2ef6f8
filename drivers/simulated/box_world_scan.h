#pragma once

#include "drivers/simulated/box_world.h"
#include "slam/base/random.h"
#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// How the tilting scanner looks (Sec. 2.2: 180 x 120 degrees, 181 x 256 points in 3.4 s) and errs.
struct BoxScanSettings {
  int beams = 181;
  int slices = 256;
  double lowest_pitch = -0.9599310885968813;  // -55 deg; the paper leaves the limits open [rad]
  double highest_pitch = 1.1344640137963142;  // 65 deg, together the 120 deg of the paper [rad]
  double range_sigma = 0.005;                 // LMS-200, spec 9.5 [m]
  double max_range = 32.0;                    // [m]
};

/// Casts the beams of one 3D scan, taken while the robot stands.
slam::Scan ScanBoxWorld(const BoxWorld& world, const slam::Pose3& T_map_laser,
                        const BoxScanSettings& settings, RandomStream& range_noise);

}  // namespace ariadne::drivers
