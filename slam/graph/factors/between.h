#pragma once

#include "slam/geometry/angles.h"
#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// T_a_b. Unlike T_map_a.Inverse() * T_map_b it subtracts the translations first, which keeps all digits
/// far from the map's origin.
inline Pose2 Between(const Pose2& T_map_a, const Pose2& T_map_b) {
  return {WrapAngle(T_map_b.angle - T_map_a.angle),
          T_map_a.RotationMatrix().transpose() * (T_map_b.translation - T_map_a.translation)};
}
inline Pose3 Between(const Pose3& T_map_a, const Pose3& T_map_b) {
  const Eigen::Quaterniond rotation = T_map_a.rotation.conjugate();
  return {(rotation * T_map_b.rotation).normalized(),
          rotation * (T_map_b.translation - T_map_a.translation)};
}

}  // namespace ariadne::slam
