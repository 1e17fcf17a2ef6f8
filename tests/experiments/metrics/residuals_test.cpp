#include "experiments/metrics/residuals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

using slam::MapScan;
using slam::Pose3;

const Parallel kOneThread(1);

MapScan ScanOf(const std::vector<Eigen::Vector3d>& points, const Pose3& T_map_laser = {}) {
  MapScan scan{"scan", {points, {}, {}, {}}, slam::KdTree(points), T_map_laser, true};
  slam::RequireSurfaces(scan, 8, kOneThread);
  return scan;
}

/// 21 x 21 points of the plane z = 0, 1 m apart.
std::vector<Eigen::Vector3d> Floor() {
  std::vector<Eigen::Vector3d> points;
  for (int x = -10; x <= 10; ++x) {
    for (int y = -10; y <= 10; ++y) points.emplace_back(x, y, 0.0);
  }
  return points;
}

Pose3 Shift(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), {x, y, z}}; }

TEST(MeasureResidual, TellsPointAndPlaneDistanceApart) {
  const PairResidual residual = MeasureResidual(ScanOf(Floor()), ScanOf({{0, 0, 0}, {1, 0, 0}, {2, 2, 0}}),
                                                Shift(0.3, 0.0, 0.4), 0.6, kOneThread);
  EXPECT_EQ(residual.pairs, 3U);
  EXPECT_NEAR(residual.median, 0.5, 1e-12) << "0.3 along the floor and 0.4 above it";
  EXPECT_NEAR(residual.plane_median, 0.4, 1e-12);
  EXPECT_NEAR(residual.plane_rms, 0.4, 1e-12);
}

TEST(MeasureResidual, TakesMedianAndRmsOfDifferentDistances) {
  const PairResidual residual = MeasureResidual(
      ScanOf(Floor()), ScanOf({{0, 0, 0.1}, {1, 0, -0.2}, {2, 0, 0.2}, {3, 0, 0.1}, {4, 0, 0.4}}), Pose3(),
      0.5, kOneThread);
  EXPECT_EQ(residual.pairs, 5U);
  EXPECT_NEAR(residual.median, 0.2, 1e-12);
  EXPECT_NEAR(residual.plane_median, 0.2, 1e-12) << "without its sign";
  EXPECT_NEAR(residual.plane_rms, std::sqrt((0.01 + 0.04 + 0.04 + 0.01 + 0.16) / 5.0), 1e-12);
}

TEST(MeasureResidual, LeavesOutWhatIsBeyondTheGate) {
  const MapScan model = ScanOf(Floor()), data = ScanOf({{0, 0, 0.1}, {1, 0, 0.3}, {2, 0, 5.0}});
  EXPECT_EQ(MeasureResidual(model, data, Pose3(), 0.5, kOneThread).pairs, 2U);
  EXPECT_EQ(MeasureResidual(model, data, Pose3(), 0.2, kOneThread).pairs, 1U);
  const PairResidual none = MeasureResidual(model, data, Shift(0, 0, 50), 0.5, kOneThread);
  EXPECT_EQ(none.pairs, 0U);
  EXPECT_EQ(none.median, 0.0);
  EXPECT_EQ(none.plane_rms, 0.0);
}

TEST(MeasureResidual, HasNoPlaneDistanceWhereTheModelHasNoSurface) {
  std::vector<Eigen::Vector3d> line;
  for (int x = 0; x < 20; ++x) line.emplace_back(x, 0.0, 0.0);
  const PairResidual residual =
      MeasureResidual(ScanOf(line), ScanOf({{5, 0, 0.2}}), Pose3(), 0.5, kOneThread);
  EXPECT_EQ(residual.pairs, 1U);
  EXPECT_NEAR(residual.median, 0.2, 1e-12);
  EXPECT_EQ(residual.plane_median, 0.0);
}

/// Three scans of the floor: the second rises by 0.1 m at the odometry's pose, the third is far away.
class MeasureResidualsTest : public testing::Test {
 protected:
  MeasureResidualsTest() {
    for (const double height : {0.0, 0.02, 90.0}) scans_.push_back(ScanOf(Floor(), Shift(0, 0, height)));
  }
  std::vector<MapScan> scans_;
  std::vector<Pose3> T_odom_laser_{Pose3(), Shift(0, 0, 0.1), Shift(0, 0, 90)};
};

TEST_F(MeasureResidualsTest, ComparesOverlappingPairsBeforeAndAfter) {
  const auto changes = MeasureResiduals(scans_, T_odom_laser_, {}, kOneThread);
  ASSERT_EQ(changes.size(), 1U) << "the third scan overlaps none";
  EXPECT_EQ(changes[0].model, 0U);
  EXPECT_EQ(changes[0].data, 1U);
  EXPECT_EQ(changes[0].before.pairs, 441U);
  EXPECT_NEAR(changes[0].before.plane_median, 0.1, 1e-12);
  EXPECT_NEAR(changes[0].after.plane_median, 0.02, 1e-12);
}

TEST_F(MeasureResidualsTest, TakesPairsWithMoreThanTheGivenOverlap) {
  EXPECT_EQ(MeasureResiduals(scans_, T_odom_laser_, {.min_pairs = 440}, kOneThread).size(), 1U);
  EXPECT_EQ(MeasureResiduals(scans_, T_odom_laser_, {.min_pairs = 441}, kOneThread).size(), 0U);
}

TEST_F(MeasureResidualsTest, DecidesOnTheOverlapInTheMapNotBefore) {
  T_odom_laser_[1] = Shift(0, 0, 7);
  const auto changes = MeasureResiduals(scans_, T_odom_laser_, {}, kOneThread);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].before.pairs, 0U);
  EXPECT_EQ(changes[0].after.pairs, 441U);
}

TEST_F(MeasureResidualsTest, DoesNotDependOnTheNumberOfThreads) {
  const auto one = MeasureResiduals(scans_, T_odom_laser_, {}, Parallel(1));
  const auto two = MeasureResiduals(scans_, T_odom_laser_, {}, Parallel(2));
  ASSERT_EQ(one.size(), two.size());
  EXPECT_EQ(one[0].after.plane_rms, two[0].after.plane_rms);
}

}  // namespace
}  // namespace ariadne::experiments
