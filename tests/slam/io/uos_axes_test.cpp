#include "slam/io/uos_axes.h"

#include <gtest/gtest.h>

#include "slam/geometry/angles.h"
#include "slam/geometry/euler.h"

namespace ariadne::slam {
namespace {

TEST(UosAxes, ConvertsPointsByHand) {
  // 1 m to the right, 2 m up, 3 m ahead.
  const Eigen::Vector3d p_uos(100.0, 200.0, 300.0);
  EXPECT_TRUE(FromUosPoint(p_uos).isApprox(Eigen::Vector3d(3.0, -1.0, 2.0), 1e-15));
  EXPECT_TRUE(ToUosPoint({3.0, -1.0, 2.0}).isApprox(p_uos, 1e-15));
}

TEST(UosAxes, ConvertsAYawByHand) {
  // In left-handed axes with y up, +90 deg about y turns z (ahead) to x (right): a yaw of -90 deg.
  const Pose3 T = FromUosPose({{0.0, 0.0, 156.0}, {0.0, 90.0, 0.0}});
  EXPECT_TRUE((T * Eigen::Vector3d(1.0, 0.0, 0.0)).isApprox(Eigen::Vector3d(1.56, -1.0, 0.0), 1e-12));
}

TEST(UosAxes, PosesMovePointsAsInUos) {
  const UosPose pose{{-3.10605, -7.50803, 156.917},
                     {1.35694, -0.852409, -0.56224}};  // hallway/scan001.pose
  const Eigen::Matrix3d R_uos = RotationFromEulerXyz(pose.euler_deg * RadFromDeg(1.0));
  const Pose3 T_map_laser = FromUosPose(pose);
  for (const Eigen::Vector3d& p_uos :
       {Eigen::Vector3d(120.0, -40.0, 700.0), Eigen::Vector3d(-9.0, 31.0, 2.0)}) {
    const Eigen::Vector3d p_map_uos = R_uos * p_uos + pose.position_cm;
    EXPECT_TRUE((T_map_laser * FromUosPoint(p_uos)).isApprox(FromUosPoint(p_map_uos), 1e-14));
  }
}

TEST(UosAxes, RoundTrips) {
  const UosPose pose{{-3.5, 7.25, 156.0}, {10.0, -20.0, 170.0}};
  const UosPose again = ToUosPose(FromUosPose(pose));
  EXPECT_TRUE(again.position_cm.isApprox(pose.position_cm, 1e-14));
  EXPECT_TRUE(again.euler_deg.isApprox(pose.euler_deg, 1e-13));
}

}  // namespace
}  // namespace ariadne::slam
