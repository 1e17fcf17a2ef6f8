#include "slam/geometry/euler.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ariadne::slam {

Eigen::Matrix3d RotationFromEulerXyz(const Eigen::Vector3d& angles) {
  return (Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

Eigen::Vector3d EulerXyzFromRotation(const Eigen::Matrix3d& R) {
  const double cosine_y = std::hypot(R(0, 0), R(0, 1));
  const double y = std::atan2(R(0, 2), cosine_y);
  if (cosine_y < 1e-12) return {std::atan2(R(2, 1), R(1, 1)), y, 0.0};  // gimbal lock
  return {std::atan2(-R(1, 2), R(2, 2)), y, std::atan2(-R(0, 1), R(0, 0))};
}

}  // namespace ariadne::slam
