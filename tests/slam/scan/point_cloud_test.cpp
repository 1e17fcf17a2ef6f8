#include "slam/scan/point_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/slam/geometry/matrix_matchers.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Six points at x = 1 .. 6 in slices of 2, 3 and 1, with all attributes.
PointCloud SixPoints() {
  PointCloud cloud;
  for (int i = 1; i <= 6; ++i) {
    cloud.positions.emplace_back(i, 0.0, 0.0);
    cloud.reflectance.push_back(10.0F * static_cast<float>(i));
    cloud.normals.push_back(Eigen::Vector3d(0.0, 1.0, i).normalized());
  }
  cloud.slice_begin = {0, 2, 5};
  return cloud;
}

std::vector<double> Xs(const PointCloud& cloud) {
  std::vector<double> xs;
  for (const Eigen::Vector3d& p : cloud.positions) xs.push_back(p.x());
  return xs;
}

TEST(PointCloud, IsEmptyAndUnorganizedByDefault) {
  EXPECT_TRUE(PointCloud().empty());
  EXPECT_EQ(PointCloud().size(), 0u);
  EXPECT_FALSE(PointCloud().organized());
}

TEST(Transformed, MovesPointsAndTurnsNormals) {
  PointCloud cloud_laser;
  cloud_laser.positions = {{1.0, 0.0, 0.0}, {0.0, 2.0, 3.0}};
  cloud_laser.normals = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  const Pose3 T_map_laser{
      Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ())),
      {10.0, 20.0, 30.0}};
  const PointCloud cloud_map = Transformed(T_map_laser, cloud_laser);
  EXPECT_THAT(cloud_map.positions[0], NearMatrix(Eigen::Vector3d(10.0, 21.0, 30.0), 1e-14));
  EXPECT_THAT(cloud_map.positions[1], NearMatrix(Eigen::Vector3d(8.0, 20.0, 33.0), 1e-14));
  EXPECT_THAT(cloud_map.normals[0], NearMatrix(Eigen::Vector3d(0.0, 1.0, 0.0), 1e-15));
  EXPECT_THAT(cloud_map.normals[1], NearMatrix(Eigen::Vector3d(-1.0, 0.0, 0.0), 1e-15));
}

TEST(Transformed, KeepsReflectanceAndSlices) {
  const Pose3 shift{Eigen::Quaterniond::Identity(), {100.0, 0.0, 0.0}};
  const PointCloud moved = Transformed(shift, SixPoints());
  EXPECT_THAT(Xs(moved), ElementsAre(101, 102, 103, 104, 105, 106));
  EXPECT_EQ(moved.reflectance, SixPoints().reflectance);
  EXPECT_EQ(moved.slice_begin, SixPoints().slice_begin);
  EXPECT_TRUE(Transformed(shift, {}).empty());
}

TEST(Selected, TakesAttributesAndSlicesAlong) {
  const PointCloud selected = Selected(SixPoints(), {1, 3, 4, 5});
  EXPECT_THAT(Xs(selected), ElementsAre(2, 4, 5, 6));
  EXPECT_THAT(selected.reflectance, ElementsAre(20, 40, 50, 60));
  EXPECT_EQ(selected.normals.at(1), SixPoints().normals[3]);
  EXPECT_EQ(selected.normals.size(), 4u);
  EXPECT_THAT(selected.slice_begin, ElementsAre(0, 1, 3));
}

TEST(Selected, KeepsSlicesThatLostAllTheirPoints) {
  EXPECT_THAT(Selected(SixPoints(), {0, 1, 5}).slice_begin, ElementsAre(0, 2, 2));
  EXPECT_THAT(Selected(SixPoints(), {2}).slice_begin, ElementsAre(0, 0, 1));
  EXPECT_THAT(Selected(SixPoints(), {}).slice_begin, ElementsAre(0, 0, 0));
}

TEST(Selected, InventsNoAttributes) {
  PointCloud bare;
  bare.positions = SixPoints().positions;
  const PointCloud selected = Selected(bare, {0, 5});
  EXPECT_THAT(Xs(selected), ElementsAre(1, 6));
  EXPECT_THAT(selected.reflectance, IsEmpty());
  EXPECT_THAT(selected.normals, IsEmpty());
  EXPECT_FALSE(selected.organized());
}

TEST(WithinRange, KeepsPointsStrictlyBetweenTheRanges) {
  const PointCloud kept = WithinRange(SixPoints(), 2.0, 5.0);
  EXPECT_THAT(Xs(kept), ElementsAre(3, 4));
  EXPECT_THAT(kept.reflectance, ElementsAre(30, 40));
  EXPECT_THAT(kept.slice_begin, ElementsAre(0, 0, 2));
}

TEST(WithinRange, MeasuresInAllThreeDimensionsAndDropsNonFinitePoints) {
  PointCloud cloud;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  cloud.positions = {{-2.0, -3.0, 6.0}, {nan, 0.0, 7.0}, {infinity, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  EXPECT_THAT(Xs(WithinRange(cloud, 6.9, 7.1)), ElementsAre(-2.0));
  EXPECT_TRUE(WithinRange(cloud, 7.0, 8.0).empty());
}

TEST(Append, JoinsPointsAttributesAndSlices) {
  PointCloud cloud = SixPoints();
  Append(cloud, Selected(SixPoints(), {0, 4}));
  EXPECT_THAT(Xs(cloud), ElementsAre(1, 2, 3, 4, 5, 6, 1, 5));
  EXPECT_THAT(cloud.reflectance, ElementsAre(10, 20, 30, 40, 50, 60, 10, 50));
  EXPECT_EQ(cloud.normals.size(), 8u);
  EXPECT_EQ(cloud.normals.at(7), SixPoints().normals[4]);
  EXPECT_THAT(cloud.slice_begin, ElementsAre(0, 2, 5, 6, 7, 8));
}

TEST(Append, ToNothingOrOfNothingKeepsEverything) {
  PointCloud from_nothing;
  Append(from_nothing, SixPoints());
  PointCloud with_nothing = SixPoints();
  Append(with_nothing, {});
  for (const PointCloud& cloud : {from_nothing, with_nothing}) {
    EXPECT_EQ(cloud.positions, SixPoints().positions);
    EXPECT_EQ(cloud.reflectance, SixPoints().reflectance);
    EXPECT_EQ(cloud.normals, SixPoints().normals);
    EXPECT_EQ(cloud.slice_begin, SixPoints().slice_begin);
  }
}

TEST(Append, DropsEachAttributeThatOneOfThemLacks) {
  PointCloud without_reflectance = SixPoints();
  without_reflectance.reflectance.clear();
  PointCloud unorganized = SixPoints();
  unorganized.slice_begin.clear();
  unorganized.normals.clear();

  PointCloud cloud = SixPoints();
  Append(cloud, without_reflectance);
  EXPECT_THAT(cloud.reflectance, IsEmpty());
  EXPECT_EQ(cloud.normals.size(), 12u);
  EXPECT_EQ(cloud.slice_begin.size(), 6u);

  cloud = SixPoints();
  Append(cloud, unorganized);
  EXPECT_EQ(cloud.reflectance.size(), 12u);
  EXPECT_THAT(cloud.normals, IsEmpty());
  EXPECT_FALSE(cloud.organized());

  Append(unorganized, SixPoints());
  EXPECT_EQ(unorganized.size(), 12u);
  EXPECT_THAT(unorganized.normals, IsEmpty());
  EXPECT_FALSE(unorganized.organized());
}

TEST(FirstNonFinite, FindsTheFirstBadCoordinate) {
  PointCloud cloud = SixPoints();
  EXPECT_EQ(FirstNonFinite(cloud), std::nullopt);
  EXPECT_EQ(FirstNonFinite({}), std::nullopt);
  cloud.positions[4].z() = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(FirstNonFinite(cloud), 4u);
  cloud.positions[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FirstNonFinite(cloud), 1u);
}

}  // namespace
}  // namespace ariadne::slam
