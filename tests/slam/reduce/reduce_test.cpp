#include "slam/reduce/reduce.h"

#include <gtest/gtest.h>

#include "tests/support/hallway.h"

namespace ariadne::slam {
namespace {

/// Two slices of points that every method reduces in its own way.
PointCloud SmallCloud() {
  PointCloud cloud;
  for (int i = 0; i < 40; ++i) {
    if (i % 20 == 0) cloud.slice_begin.push_back(cloud.size());
    cloud.positions.emplace_back(0.03 * i, 0.01 * i * i, 0.5 * (i / 20));
  }
  return cloud;
}

PointCloud ReducedBy(ReduceMethod method) {
  ReduceOptions options;
  options.method = method;
  options.join_distance = 0.07;
  options.keep_every = 2;
  options.voxel_size = 0.15;
  options.seed = 5;
  return Reduce(SmallCloud(), options);
}

TEST(Reduce, DoesWhatTheMethodSays) {
  const PointCloud cloud = SmallCloud();
  const auto octree = [&](Representative representative) {
    return ReduceOctree(cloud, 0.15, representative, 5).positions;
  };
  EXPECT_EQ(ReducedBy(ReduceMethod::kNone).positions, cloud.positions);
  EXPECT_EQ(ReducedBy(ReduceMethod::kNone).slice_begin, cloud.slice_begin);
  EXPECT_EQ(ReducedBy(ReduceMethod::kSlices).positions, ReduceSlices(cloud, 0.07, 2).positions);
  EXPECT_EQ(ReducedBy(ReduceMethod::kVoxelMean).positions, ReduceVoxels(cloud, 0.15).positions);
  EXPECT_EQ(ReducedBy(ReduceMethod::kOctreeCenter).positions, octree(Representative::kCenter));
  EXPECT_EQ(ReducedBy(ReduceMethod::kOctreeMean).positions, octree(Representative::kMean));
  EXPECT_EQ(ReducedBy(ReduceMethod::kOctreeRandom).positions, octree(Representative::kRandom));
  EXPECT_NE(octree(Representative::kMean), octree(Representative::kRandom));
  EXPECT_NE(octree(Representative::kRandom),
            ReduceOctree(cloud, 0.15, Representative::kRandom, 6).positions);
}

TEST(ReduceOptions, HaveDefaultsInTheirRanges) { EXPECT_NO_THROW(CheckOptions(ReduceOptions())); }

using Hallway = HallwayTest;

TEST_F(Hallway, HasAsManyOctreeLeavesAs3dtkFinds) {
  ReduceOptions options;
  options.method = ReduceMethod::kOctreeCenter;
  options.voxel_size = 0.2;
  const std::vector<std::size_t> of_3dtk = {9286, 7388, 7179};  // -r 10 on the same points
  ASSERT_EQ(Scans().size(), of_3dtk.size());
  for (std::size_t i = 0; i < of_3dtk.size(); ++i) {
    EXPECT_EQ(Reduce(Scans()[i].cloud_laser, options).size(), of_3dtk[i]) << Scans()[i].name;
  }
}

}  // namespace
}  // namespace ariadne::slam
