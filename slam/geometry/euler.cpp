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
  // z is read off Rx(-x) * R, which keeps the product exact near the lock, where x alone is uncertain.
  const double x = std::atan2(-R(1, 2), R(2, 2));
  return {x, y,
          std::atan2(std::cos(x) * R(1, 0) + std::sin(x) * R(2, 0),
                     std::cos(x) * R(1, 1) + std::sin(x) * R(2, 1))};
}

}  // namespace ariadne::slam
