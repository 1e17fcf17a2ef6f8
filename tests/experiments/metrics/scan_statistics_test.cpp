#include "experiments/metrics/scan_statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

using testing::AllOf;
using testing::HasSubstr;

slam::PointCloud CloudOf(std::vector<Eigen::Vector3d> positions) {
  return {std::move(positions), {}, {}, {}};
}

/// A wall of points 10 cm apart, 2 m before the laser: nothing is wrong with it.
std::vector<Eigen::Vector3d> Wall() {
  std::vector<Eigen::Vector3d> points;
  for (int y = -20; y <= 20; ++y) {
    for (int z = -10; z <= 10; ++z) points.emplace_back(2.0 + 1e-4 * y, 0.1 * y, 0.1 * z);
  }
  return points;
}

TEST(MeasureScan, MeasuresAFewPointsByHand) {
  const ScanStatistics s = MeasureScan(CloudOf({{1, 0, 0}, {0, 2, 0}, {0, 0, -3}, {0, 4, 0}, {5, 0, 0}}));
  EXPECT_EQ(s.points, 5U);
  EXPECT_EQ(s.extent, Eigen::Vector3d(5.0, 4.0, 3.0));
  EXPECT_EQ(s.min_range, 1.0);
  EXPECT_EQ(s.median_range, 3.0);
  EXPECT_EQ(s.max_range, 5.0);
  EXPECT_NEAR(s.median_spacing, std::sqrt(5.0), 1e-12) << "sqrt 5, 2, sqrt 10, 2, 4 sorted: the middle";
}

TEST(MeasureScan, TellsSlicesAndReflectance) {
  slam::PointCloud cloud = CloudOf(Wall());
  EXPECT_EQ(MeasureScan(cloud).slices, 0U);
  EXPECT_FALSE(MeasureScan(cloud).has_reflectance);
  cloud.slice_begin = {0, 21, 42};
  cloud.reflectance.assign(cloud.size(), 1.0F);
  EXPECT_EQ(MeasureScan(cloud).slices, 3U);
  EXPECT_TRUE(MeasureScan(cloud).has_reflectance);
}

TEST(MeasureScan, FindsNothingWrongWithAWall) {
  const ScanStatistics s = MeasureScan(CloudOf(Wall()));
  EXPECT_EQ(s.suspicious, "");
  EXPECT_NEAR(s.median_spacing, 0.1, 1e-4);
}

TEST(MeasureScan, SuspectsPointsOnTheRobot) {
  std::vector<Eigen::Vector3d> points = Wall();
  points.emplace_back(0.1, 0.1, 0.0);
  EXPECT_THAT(MeasureScan(CloudOf(points)).suspicious, HasSubstr("0.1 % nearer than 0.2 m"));
}

TEST(MeasureScan, SuspectsNoReturnsStoredAsTheLargestRange) {
  std::vector<Eigen::Vector3d> points = Wall();
  for (int i = 0; i < 95; ++i) {
    const double angle = 0.01 * i;
    points.emplace_back(81.91 * std::cos(angle), 81.91 * std::sin(angle), 0.0);
  }
  EXPECT_THAT(MeasureScan(CloudOf(points)).suspicious,
              HasSubstr("9.9 % at 81.91 m, the largest range: no-returns"));
}

TEST(MeasureScan, SuspectsARangeThatIsNoRoom) {
  std::vector<Eigen::Vector3d> points = Wall();
  points.emplace_back(1e6, 0.0, 0.0);
  EXPECT_THAT(MeasureScan(CloudOf(points)).suspicious, HasSubstr("a range of 1000000 m"));
}

TEST(MeasureScan, SuspectsRepeatedPoints) {
  std::vector<Eigen::Vector3d> points = Wall();
  const std::vector<Eigen::Vector3d> once = points;
  points.insert(points.end(), once.begin(), once.end());
  EXPECT_EQ(MeasureScan(CloudOf(points)).suspicious, "100.0 % repeated points");
}

TEST(MeasureScan, ListsAllThatIsSuspicious) {
  std::vector<Eigen::Vector3d> points = Wall();
  points.insert(points.end(), {{0.0, 0.0, 0.0}, {1e6, 0.0, 0.0}, {1e6, 0.0, 0.0}});
  EXPECT_THAT(
      MeasureScan(CloudOf(points)).suspicious,
      AllOf(HasSubstr("nearer than 0.2 m; "), HasSubstr("a range of "), HasSubstr("repeated points")));
}

TEST(MeasureScan, TakesNoneOrOnePoint) {
  EXPECT_EQ(MeasureScan({}).suspicious, "no points");
  EXPECT_EQ(MeasureScan({}).points, 0U);
  const ScanStatistics one = MeasureScan(CloudOf({{3, 0, 4}}));
  EXPECT_EQ(one.median_range, 5.0);
  EXPECT_EQ(one.median_spacing, 0.0);
}

}  // namespace
}  // namespace ariadne::experiments
