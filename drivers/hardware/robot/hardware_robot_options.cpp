#include "drivers/hardware/robot/hardware_robot_options.h"

namespace ariadne::drivers {

slam::Pose3 LaserMountOptions::T_base_laser() const {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  slam::Pose3 T;
  T.translation = {x, y, z};
  T.rotation = AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(-pitch, Vector3d::UnitY()) *
               AngleAxisd(roll, Vector3d::UnitX());
  return T;
}

double LeadOf(const TiltOptions& tilt, double rate, double duration) {
  return 0.5 * rate * rate / tilt.acceleration + rate * (0.5 * tilt.window + duration);
}

}  // namespace ariadne::drivers
