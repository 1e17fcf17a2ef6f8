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

/// A lag fades by e in its own time: after four of them 1 % of it is left.
double LeadOf(const TiltOptions& tilt, double rate, double duration, double lag) {
  return 0.5 * rate * rate / tilt.acceleration + rate * (0.5 * tilt.window + duration + 4.0 * lag);
}

}  // namespace ariadne::drivers
