#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// A pose as the files of the uos family say it: centimetres and degrees in LEFT-handed axes, x right, y
/// up, z forward; the rotation is Rx(euler.x) * Ry(euler.y) * Rz(euler.z) in these axes.
struct UosPose {
  Eigen::Vector3d position_cm = Eigen::Vector3d::Zero();
  Eigen::Vector3d euler_deg = Eigen::Vector3d::Zero();
};

UosPose ToUosPose(const Pose3& T_map_laser);
Pose3 FromUosPose(const UosPose& pose);

/// The same point [m], x forward, y left, z up, as [cm] in the axes of uos, and back.
inline Eigen::Vector3d ToUosPoint(const Eigen::Vector3d& p) {
  return {-100.0 * p.y(), 100.0 * p.z(), 100.0 * p.x()};
}
inline Eigen::Vector3d FromUosPoint(const Eigen::Vector3d& p_uos) {
  return {0.01 * p_uos.z(), -0.01 * p_uos.x(), 0.01 * p_uos.y()};
}

/// The same rotation in the axes of uos, and back.
Eigen::Matrix3d ToUosRotation(const Eigen::Matrix3d& R);
Eigen::Matrix3d FromUosRotation(const Eigen::Matrix3d& R_uos);

}  // namespace ariadne::slam
