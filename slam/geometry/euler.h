#pragma once

#include <Eigen/Core>

namespace ariadne::slam {

/// R = Rx(a.x) * Ry(a.y) * Rz(a.z): the order of the pose files of the uos family. [rad]
/// The formula does not know the handedness of the axes; slam/io/uos does.
Eigen::Matrix3d RotationFromEulerXyz(const Eigen::Vector3d& angles);

/// The angles of a rotation, a.y in [-pi/2, pi/2]. Where a.y = +-pi/2 only a combination of the other two
/// is determined, and a.z is set to 0.
Eigen::Vector3d EulerXyzFromRotation(const Eigen::Matrix3d& R);

}  // namespace ariadne::slam
