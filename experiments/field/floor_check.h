#pragma once

#include "drivers/hardware/robot/hardware_robot_options.h"
#include "slam/scan/scan.h"

namespace ariadne::experiments {

/// Where a scan has the floor, by a mount that is taken to be right.
struct FloorSeen {
  std::size_t points = 0;  // 0: there is none
  double height = 0.0;     // where the robot stands [m]
  double slope = 0.0;      // steepest [m/m]
};
FloorSeen SeeFloor(const slam::Scan& scan, const drivers::LaserMountOptions& mount);

}  // namespace ariadne::experiments
