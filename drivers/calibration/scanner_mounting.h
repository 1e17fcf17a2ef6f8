#pragma once

#include <Eigen/Core>

#include "slam/scan/scan.h"

namespace ariadne::drivers {

/// How a tilted 2D scanner sits on its robot, as far as scans of floors and walls can tell. The robot's
/// frame is level with the floor, its origin below the tilt axis. A zero of the servo that is off is part
/// of the pitch; where the robot's "ahead" is (yaw), and where on the base, no scan tells.
struct ScannerMounting {
  double roll = 0.0;            // of the tilt axis, about x: its left end up [rad]
  double pitch = 0.0;           // of the level scanner, positive looks up [rad]
  double height = 0.95;         // of the tilt axis above the floor [m]
  double mirror_forward = 0.0;  // the mirror's centre ahead of the tilt axis, at pitch 0 [m]
  double mirror_up = 0.0;       // and above it [m]
  double range_offset = 0.0;    // that is missing in the ranges [m]

  static constexpr int kSize = 6;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  Vector ToVector() const { return Vector(roll, pitch, height, mirror_forward, mirror_up, range_offset); }
  static ScannerMounting Of(const Vector& v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }
};

/// One measured beam: its direction in the plane of the slice, and the pitch of that at its own time.
struct MeasuredBeam {
  double angle = 0.0;  // 0 is to the right [rad]
  double pitch = 0.0;  // by the servo [rad]
  double range = 0.0;  // [m]
};

/// Where a beam ends, in the robot's frame, and how that changes with the mounting.
struct BeamEnd {
  Eigen::Vector3d p_base;
  Eigen::Matrix<double, 3, ScannerMounting::kSize> derivative;
};
BeamEnd EndOf(const MeasuredBeam& beam, const ScannerMounting& mounting);

}  // namespace ariadne::drivers
