#pragma once

#include <limits>
#include <vector>

#include "slam/geometry/pose2.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A 2D laser range finder whose plane is pitched by a servo (Sec. 2.2). Seen along the beams' order it
/// sweeps from right (angle 0) over ahead (90 deg) to left (180 deg).
struct ScannerModel {
  double first_angle = 0.0;         // of beam 0 in the slice plane, 0 is to the right [rad]
  double angle_step = 0.0;          // between neighbouring beams [rad]
  int turns_per_sweep = 1;          // the mirror turns once per degree, 2 (4) times for 0.5 (0.25) deg
  double turn_period = 1.0 / 75.0;  // [s]
};

/// One slice: what the 2D scanner measures at one pitch.
struct LaserSweep {
  static constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();

  double stamp = 0.0;              // when beam angle 0 passes in the first turn [s]
  double pitch = 0.0;              // of the slice plane at `stamp`; positive looks up [rad]
  double pitch_rate = 0.0;         // while the sweep lasts [rad/s]
  std::vector<float> ranges;       // one per beam, kNoReturn where nothing came back [m]
  std::vector<float> reflectance;  // empty, or one per beam
};

/// Where the robot believes to be from its wheels alone.
struct Odometry {
  Pose2 T_odom_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of T_odom_base, in its tangent space
};

/// One 3D scan as the device delivers it: rows are slices.
struct Scan {
  ScannerModel scanner;
  Odometry odometry;
  std::vector<LaserSweep> sweeps;
};

/// When a beam of a sweep is measured, after the sweep's stamp [s]. With several turns per sweep,
/// neighbouring beams belong to successive turns (spec 9.2: interleaved partial scans).
double BeamTime(const ScannerModel& scanner, std::size_t beam);

/// The unit vector of a beam in the laser frame (x forward, y left, z up) at a pitch [rad].
Eigen::Vector3d BeamDirection(const ScannerModel& scanner, std::size_t beam, double pitch);

/// The returns of a scan as an organized cloud in the laser frame, each at the pitch of its own time.
PointCloud ToPointCloud(const Scan& scan);

}  // namespace ariadne::slam
