#include "experiments/field/floor_check.h"

#include <Eigen/Cholesky>
#include <array>

#include "drivers/calibration/calibration_planes.h"

namespace ariadne::experiments {

/// A plane z = a + b x + c y through the points of all pieces of floor.
FloorSeen SeeFloor(const slam::Scan& scan, const drivers::LaserMountOptions& mount) {
  const drivers::ScannerMounting mounting{mount.roll, mount.pitch, mount.z, 0.0, 0.0, 0.0};
  FloorSeen floor;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  const std::array<slam::Scan, 1> scans{scan};
  for (const drivers::CalibrationPlane& plane : drivers::FindCalibrationPlanes(scans, mounting, {})) {
    if (plane.kind != drivers::PlaneKind::kFloor) continue;
    for (const drivers::MeasuredBeam& beam : plane.beams) {
      const Eigen::Vector3d p_base = drivers::EndOf(beam, mounting).p_base;
      const Eigen::Vector3d row(1.0, p_base.x(), p_base.y());
      A += row * row.transpose();
      b += row * p_base.z();
      ++floor.points;
    }
  }
  if (floor.points == 0) return floor;
  const Eigen::Vector3d plane = A.ldlt().solve(b);
  floor.height = plane[0];
  floor.slope = plane.tail<2>().norm();
  return floor;
}

}  // namespace ariadne::experiments
