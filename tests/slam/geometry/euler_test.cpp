#include "slam/geometry/euler.h"

#include <gtest/gtest.h>

#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

TEST(EulerXyz, RoundTrips) {
  const Eigen::Vector3d angles(RadFromDeg(10), RadFromDeg(-20), RadFromDeg(170));
  EXPECT_TRUE(EulerXyzFromRotation(RotationFromEulerXyz(angles)).isApprox(angles, 1e-14));
}

}  // namespace
}  // namespace ariadne::slam
