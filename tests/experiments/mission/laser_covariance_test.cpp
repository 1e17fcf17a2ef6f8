#include "experiments/mission/laser_covariance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/random.h"
#include "slam/geometry/so3.h"

namespace ariadne::experiments {
namespace {

/// A lower triangle with these sigmas and some correlation.
slam::Pose2::Square RootOfCovariance() {
  slam::Pose2::Square root;
  root << 0.02, 0.0, 0.0, 0.01, 0.03, 0.0, -0.004, 0.006, 0.01;
  return root;
}

TEST(LaserCovariance, IsTheScatterOfTheLaserOfRobotsThatScatter) {
  const slam::Pose3 T_base_laser{slam::ExpSo3({0.02, 0.1, 0.4}), {0.3, -0.1, 0.9}};
  const slam::Pose2::Square root = RootOfCovariance();
  constexpr double kHeight = 0.01, kTilt = 0.005;
  RandomStream stream = NamedStream(3, "laser_covariance_test");
  slam::Pose3::Square scatter = slam::Pose3::Square::Zero();
  constexpr int kRobots = 40000;
  for (int n = 0; n < kRobots; ++n) {
    slam::Pose2::Tangent unit;
    for (int i = 0; i < 3; ++i) unit[i] = DrawNormal(stream, 0.0, 1.0);
    const slam::Pose2::Tangent on_floor = root * unit;
    slam::Pose3::Tangent off_base;
    off_base << on_floor[0], on_floor[1], 0.0, 0.0, 0.0, on_floor[2];
    off_base[2] = kHeight * DrawNormal(stream, 0.0, 1.0);
    off_base[3] = kTilt * DrawNormal(stream, 0.0, 1.0);
    off_base[4] = kTilt * DrawNormal(stream, 0.0, 1.0);
    const slam::Pose3::Tangent off =
        (T_base_laser.Inverse() * slam::Pose3::Exp(off_base) * T_base_laser).Log();
    scatter += off * off.transpose() / kRobots;
  }
  const slam::Pose3::Square said = LaserCovariance(root * root.transpose(), T_base_laser, kHeight, kTilt);
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(said(i, k), scatter(i, k), 0.03 * std::sqrt(said(i, i) * said(k, k))) << i << " " << k;
  }
}

}  // namespace
}  // namespace ariadne::experiments
