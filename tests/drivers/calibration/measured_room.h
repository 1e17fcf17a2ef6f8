#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "drivers/calibration/calibration_planes.h"
#include "slam/base/random.h"

namespace ariadne::drivers {

/// How a scan of an empty room is made: ranges are distances along lines that start at the mirror, worked
/// out from the drawing of the mount, and not by what the calibration uses.
struct RoomScanOptions {
  ScannerMounting truth;
  int slices = 64;
  int beams = 91;
  double range_noise = 0.01;   // of each beam [m]
  double pitch_noise = 0.001;  // of each slice [rad]
  double yaw = 0.4;            // of the robot in the room [rad]
  double lowest = -0.96;       // [rad]
  double highest = 1.13;       // [rad]
  bool ceiling = true;
};

struct RoomScan {
  slam::Scan scan;
  std::vector<CalibrationPlane> planes;  // floor, four walls, ceiling; who was hit is known
};

inline RoomScan ScanRoom(const RoomScanOptions& options, RandomStream& stream) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const ScannerMounting& m = options.truth;
  const std::array<Vector3d, 6> normals{Vector3d(0, 0, 1), Vector3d(1, 0, 0),  Vector3d(-1, 0, 0),
                                        Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(0, 0, -1)};
  const std::array<double, 6> distances{0.0, -2.0, -4.0, -2.5, -3.0, -2.7};  // normal . p >= distance
  RoomScan result;
  for (std::size_t i = 0; i < 6; ++i) {
    CalibrationPlane plane;
    plane.kind = i == 0 ? PlaneKind::kFloor : i == 5 ? PlaneKind::kCeiling : PlaneKind::kWall;
    const Vector3d normal_base = AngleAxisd(-options.yaw, Vector3d::UnitZ()) * normals[i];
    plane.bearing = std::atan2(normal_base.y(), normal_base.x()) + 0.01;
    plane.offset = (i == 5 ? 2.7 : distances[i]) + 0.02;
    result.planes.push_back(plane);
  }
  const double step = std::numbers::pi / (options.beams - 1);
  result.scan.scanner = {0.0, step, 1, 1.0 / 75.0};
  const AngleAxisd mount_pitch(-m.pitch, Vector3d::UnitY()), mount_roll(m.roll, Vector3d::UnitX()),
      yaw(options.yaw, Vector3d::UnitZ());
  for (int slice = 0; slice < options.slices; ++slice) {
    const double told = options.lowest + (options.highest - options.lowest) * slice / (options.slices - 1);
    const AngleAxisd tilt(-(told + DrawNormal(stream, 0.0, options.pitch_noise)), Vector3d::UnitY());
    const Eigen::Matrix3d turn = (yaw * mount_pitch * mount_roll * tilt).toRotationMatrix();
    const Vector3d from = Vector3d(0, 0, m.height) + turn * Vector3d(m.mirror_forward, 0, m.mirror_up);
    slam::LaserSweep sweep;
    sweep.pitch = told;
    for (int beam = 0; beam < options.beams; ++beam) {
      const double angle = beam * step;
      const Vector3d along = turn * Vector3d(std::sin(angle), -std::cos(angle), 0.0);
      double range = std::numeric_limits<double>::infinity();
      std::size_t hit = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        const double rate = normals[i].dot(along);
        if (rate >= -1e-9) continue;
        const double way = (distances[i] - normals[i].dot(from)) / rate;
        if (way < range) range = way, hit = i;
      }
      range += DrawNormal(stream, 0.0, options.range_noise) - m.range_offset;
      const bool missing = hit == 5 && !options.ceiling;
      sweep.ranges.push_back(missing ? slam::LaserSweep::kNoReturn : static_cast<float>(range));
      if (missing) continue;
      result.planes[hit].beams.push_back({angle, told, range});
      result.planes[hit].slices.push_back(static_cast<std::size_t>(slice));
    }
    result.scan.sweeps.push_back(std::move(sweep));
  }
  if (!options.ceiling) result.planes.pop_back();
  return result;
}

/// A mount that is off in everything.
inline ScannerMounting CrookedMounting() {
  ScannerMounting truth;
  truth.roll = 0.021;
  truth.pitch = -0.034;
  truth.height = 0.98;
  truth.mirror_forward = 0.031;
  truth.mirror_up = -0.017;
  truth.range_offset = 0.008;
  return truth;
}

}  // namespace ariadne::drivers
