#include "drivers/calibration/scanner_mounting.h"

#include <Eigen/Geometry>
#include <cmath>

namespace ariadne::drivers {

BeamEnd EndOf(const MeasuredBeam& beam, const ScannerMounting& mounting) {
  using Eigen::Vector3d;
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(-beam.pitch, Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Matrix3d roll = Eigen::AngleAxisd(mounting.roll, Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d pitch = Eigen::AngleAxisd(-mounting.pitch, Vector3d::UnitY()).toRotationMatrix();
  const Vector3d direction(std::sin(beam.angle), -std::cos(beam.angle), 0.0);
  const Vector3d mirror(mounting.mirror_forward, 0.0, mounting.mirror_up);
  const Vector3d tilted = tilt * ((beam.range + mounting.range_offset) * direction + mirror);
  const Vector3d from_axis = pitch * roll * tilted;
  BeamEnd end;
  end.p_base = from_axis + Vector3d(0.0, 0.0, mounting.height);
  end.derivative.col(0) = pitch * roll * Vector3d::UnitX().cross(tilted);
  end.derivative.col(1) = -Vector3d::UnitY().cross(from_axis);
  end.derivative.col(2) = Vector3d::UnitZ();
  end.derivative.col(3) = pitch * roll * tilt.col(0);
  end.derivative.col(4) = pitch * roll * tilt.col(2);
  end.derivative.col(5) = pitch * roll * tilt * direction;
  return end;
}

}  // namespace ariadne::drivers
