#include "experiments/mission/laser_covariance.h"

#include <array>

namespace ariadne::experiments {

slam::Pose3::Square LaserCovariance(const slam::Pose2::Square& covariance_base,
                                    const slam::Pose3& T_base_laser, double floor_height,
                                    double floor_tilt) {
  constexpr std::array<int, 3> kOnFloor = {0, 1, 5};  // x, y and the turn about z among the six tangents
  slam::Pose3::Tangent sigma;
  sigma << 0.0, 0.0, floor_height, floor_tilt, floor_tilt, 0.0;
  slam::Pose3::Square covariance = sigma.cwiseAbs2().asDiagonal();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) covariance(kOnFloor[i], kOnFloor[k]) = covariance_base(i, k);
  }
  const slam::Pose3::Square to_laser = T_base_laser.Inverse().Adjoint();
  return to_laser * covariance * to_laser.transpose();
}

}  // namespace ariadne::experiments
