// Reduced points as the paper makes them (Sec. 2.2.1).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "drivers/simulated/box_world_scan.h"
#include "slam/reduce/reduce.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::IsEmpty;
using testing::Lt;

/// Points on the x axis, slice by slice, with their x as y too, to see both averaged.
PointCloud Slices(const std::vector<std::vector<double>>& slices) {
  PointCloud cloud;
  for (const std::vector<double>& slice : slices) {
    cloud.slice_begin.push_back(cloud.size());
    for (const double x : slice) cloud.positions.emplace_back(x, x, 0.0);
  }
  return cloud;
}

std::vector<double> XOf(const PointCloud& cloud) {
  std::vector<double> x;
  for (const Eigen::Vector3d& p : cloud.positions) {
    EXPECT_EQ(p.y(), p.x());
    EXPECT_EQ(p.z(), 0.0);
    x.push_back(p.x());
  }
  return x;
}

TEST(ReduceSlices, JoinsRunsByTheDistanceToTheirFirstPoint) {
  // Along (1, 1) the points are sqrt(2) as far apart as their x. 0, 1 and 2 are within 3 of 0, though
  // neighbours go on being close; 3 begins the next run.
  const PointCloud reduced = ReduceSlices(Slices({{0.0, 1.0, 2.0, 3.0, 4.0, 9.0}}), 3.0, 1);
  EXPECT_THAT(XOf(reduced), ElementsAre(1.0, 3.5, 9.0));
  EXPECT_THAT(reduced.slice_begin, ElementsAre(0));
}

TEST(ReduceSlices, JoinsAtExactlyTheDistance) {
  PointCloud cloud;
  cloud.positions = {{0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {0.0, 0.0, 0.75}};
  cloud.slice_begin = {0};
  EXPECT_EQ(ReduceSlices(cloud, 0.5, 1).size(), 2u);
  EXPECT_EQ(ReduceSlices(cloud, 0.75, 1).size(), 1u);
  EXPECT_EQ(ReduceSlices(cloud, 0.0, 1).positions, cloud.positions);
}

TEST(ReduceSlices, DoesNotJoinPointsThatReturnAfterAnother) {
  EXPECT_THAT(XOf(ReduceSlices(Slices({{0.0, 10.0, 0.25}}), 1.0, 1)), ElementsAre(0.0, 10.0, 0.25));
}

TEST(ReduceSlices, NeverJoinsAcrossSlices) {
  const PointCloud reduced = ReduceSlices(Slices({{1.0, 2.0}, {2.0, 4.0}}), 100.0, 1);
  EXPECT_THAT(XOf(reduced), ElementsAre(1.5, 3.0));
  EXPECT_THAT(reduced.slice_begin, ElementsAre(0, 1));
}

TEST(ReduceSlices, KeepsEveryTthSliceFromTheFirst) {
  const PointCloud cloud = Slices({{0.0}, {1.0}, {2.0}, {3.0}, {4.0}, {5.0}, {6.0}});
  EXPECT_THAT(XOf(ReduceSlices(cloud, 0.1, 1)), ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_THAT(XOf(ReduceSlices(cloud, 0.1, 3)), ElementsAre(0.0, 3.0, 6.0));
  EXPECT_THAT(XOf(ReduceSlices(cloud, 0.1, 100)), ElementsAre(0.0));
  EXPECT_THAT(ReduceSlices(cloud, 0.1, 3).slice_begin, ElementsAre(0, 1, 2));
}

TEST(ReduceSlices, KeepsEmptySlices) {
  const PointCloud reduced = ReduceSlices(Slices({{}, {1.0, 1.5}, {}, {}, {4.0}}), 1.0, 1);
  EXPECT_THAT(XOf(reduced), ElementsAre(1.25, 4.0));
  EXPECT_THAT(reduced.slice_begin, ElementsAre(0, 0, 1, 1, 1));
}

TEST(ReduceSlices, AveragesReflectance) {
  PointCloud cloud = Slices({{0.0, 0.5, 5.0}, {7.0}, {9.0}});
  cloud.reflectance = {10.0F, 20.0F, 40.0F, 80.0F, 160.0F};
  EXPECT_THAT(ReduceSlices(cloud, 1.0, 2).reflectance, ElementsAre(15.0F, 40.0F, 160.0F));
  EXPECT_THAT(ReduceSlices(Slices({{0.0, 0.5}}), 1.0, 1).reflectance, IsEmpty());
}

TEST(ReduceSlices, TellsWhatToDoWithoutSlices) {
  PointCloud cloud;
  cloud.positions = {{1.0, 2.0, 3.0}};
  EXPECT_EQ(ErrorOf([&] { ReduceSlices(cloud, 0.1, 1); }),
            "the points are not in slices, which reduce.method=slices needs; take voxel_mean instead");
  EXPECT_TRUE(ReduceSlices({}, 0.1, 1).empty());
}

TEST(ReduceSlices, MakesTheScanOfThePaperOneOrderOfMagnitudeSmaller) {
  // 46,336 points to 4,910 in Table 1. It depends on the place: a scanner at the end of a corridor sees its
  // walls near and dense.
  const drivers::BoxWorld office = drivers::MakeOffice();
  ReduceOptions options;
  options.method = ReduceMethod::kSlices;
  std::vector<std::size_t> reduced;
  for (const Pose2& stop : drivers::OfficeTour()) {
    Pose3 T_map_laser = ToPose3(stop);
    T_map_laser.translation.z() = 1.0;
    RandomStream noise = NamedStream(1, "slices_test/range");
    const PointCloud cloud = ToPointCloud(ScanBoxWorld(office, T_map_laser, {}, noise));
    ASSERT_EQ(cloud.size(), 46'336u);
    reduced.push_back(Reduce(cloud, options).size());
  }
  EXPECT_THAT(reduced, Each(AllOf(Gt(2'000u), Lt(7'000u))));
  const double mean =
      std::accumulate(reduced.begin(), reduced.end(), 0.0) / static_cast<double>(reduced.size());
  EXPECT_GT(mean, 3'500.0);
  EXPECT_LT(mean, 7'000.0);
}

}  // namespace
}  // namespace ariadne::slam
