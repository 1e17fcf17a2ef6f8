#pragma once

#include "drivers/simulated/simulated_robot.h"
#include "slam/geometry/triangle_mesh.h"

namespace ariadne::experiments {

/// The AIS 3D scanner: the 2D range finder in its mount, pitched [rad] about the tilt axis, with the servo
/// on the left side (Sec. 2.2). Its frame is the laser's: the origin on the tilt axis, x ahead, z up. It is
/// 35 x 24 x 24 cm as the real one; how it looks inside of that is a guess.
slam::TriangleMesh ScannerMesh(double pitch);

/// The robot with its scanner (Sec. 2.1) in the base's frame, whose origin is on the floor between the
/// driven wheels. Outline, height, wheels and scanners are where the options have them; the rest is a
/// guess.
slam::TriangleMesh RobotMesh(const drivers::SimulatedRobotOptions& options, double pitch);

}  // namespace ariadne::experiments
