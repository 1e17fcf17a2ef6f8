#include "planning/polygon/row_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Eigen::Vector3d;

/// Two rows 5 degrees apart that see a wall x = 4 below and above a height of 1.5 m, beams 1 degree apart;
/// the laser is at 1.2 m. Beyond y = 1 the upper row looks through a window, to x = 9.
slam::PosedCloud WallOfTwoRows() {
  slam::PosedCloud scan{"a", {}, {}};
  scan.T_map_laser.translation = {10.0, -5.0, 1.2};
  for (const double pitch : {2.0, 7.0}) {
    scan.cloud_laser.slice_begin.push_back(scan.cloud_laser.size());
    for (int degrees = 60; degrees <= 120; ++degrees) {
      if (pitch == 7.0 && degrees == 80) continue;  // a beam that does not come back
      const double angle = degrees * std::numbers::pi / 180.0, tilt = pitch * std::numbers::pi / 180.0;
      const Vector3d u(std::sin(angle) * std::cos(tilt), -std::cos(angle),
                       std::sin(angle) * std::sin(tilt));
      const bool window = pitch == 7.0 && 4.0 / u.x() * u.y() > 1.0;
      scan.cloud_laser.positions.emplace_back((window ? 9.0 : 4.0) / u.x() * u);
    }
  }
  return scan;
}

TEST(RowCrossings, LieWhereTheSurfaceBetweenTwoRowsPassesTheHeight) {
  const auto crossings = RowCrossings(WallOfTwoRows(), {1.5, 0.02}, 0.1);
  ASSERT_GT(crossings.size(), 40U);
  for (const Eigen::Vector2d& p : crossings) {
    EXPECT_NEAR(p.x(), 14.0, 1e-9);
    EXPECT_LE(p.y(), -4.0 + 0.1);
    EXPECT_GT((p - Eigen::Vector2d(14.0, -5.0 - 4.0 * std::tan(10.0 / 180.0 * std::numbers::pi))).norm(),
              0.01);  // where a beam is missing
  }
  EXPECT_GT(RowCrossings(WallOfTwoRows(), {1.5, 0.02}, 20.0).size(), crossings.size());
}

TEST(RowCrossings, NeedRowsOnEitherSideOfTheSlice) {
  slam::PosedCloud scan = WallOfTwoRows();
  EXPECT_TRUE(RowCrossings(scan, {2.5, 0.02}, 0.1).empty());
  EXPECT_TRUE(RowCrossings(scan, {1.5, 0.3}, 0.1).empty());  // the points themselves are in the slice
  scan.cloud_laser.slice_begin.clear();
  EXPECT_TRUE(RowCrossings(scan, {1.5, 0.02}, 0.1).empty());
  scan.cloud_laser.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { RowCrossings(scan, {1.5, 0.02}, 0.1); }), testing::HasSubstr("'a'"));
}

}  // namespace
}  // namespace ariadne::planning
