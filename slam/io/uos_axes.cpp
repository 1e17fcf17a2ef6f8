#include "slam/io/uos_axes.h"

#include "slam/geometry/angles.h"
#include "slam/geometry/euler.h"

namespace ariadne::slam {
namespace {

/// C with p = C * p_uos (without the unit): a permutation with one change of sign, hence det C = -1.
Eigen::Matrix3d AxesFromUos() {
  Eigen::Matrix3d C;
  C << 0, 0, 1,  //
      -1, 0, 0,  //
      0, 1, 0;
  return C;
}

Eigen::Vector3d Map(double (*convert)(double), const Eigen::Vector3d& angles) {
  return {convert(angles.x()), convert(angles.y()), convert(angles.z())};
}

}  // namespace

Eigen::Matrix3d ToUosRotation(const Eigen::Matrix3d& R) {
  return AxesFromUos().transpose() * R * AxesFromUos();
}

Eigen::Matrix3d FromUosRotation(const Eigen::Matrix3d& R_uos) {
  return AxesFromUos() * R_uos * AxesFromUos().transpose();
}

UosPose ToUosPose(const Pose3& T_map_laser) {
  const Eigen::Matrix3d R_uos = ToUosRotation(T_map_laser.RotationMatrix());
  return {ToUosPoint(T_map_laser.translation), Map(DegFromRad, EulerXyzFromRotation(R_uos))};
}

Pose3 FromUosPose(const UosPose& pose) {
  const Eigen::Matrix3d R_uos = RotationFromEulerXyz(Map(RadFromDeg, pose.euler_deg));
  return {Eigen::Quaterniond(FromUosRotation(R_uos)).normalized(), FromUosPoint(pose.position_cm)};
}

}  // namespace ariadne::slam
