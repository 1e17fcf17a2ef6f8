#include "slam/extract/slice_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

/// A wall x = 3, from y = -1 to 1, in three slices; the tilt moves on between two beams.
PointCloud WallScan() {
  PointCloud cloud;
  for (int slice = 0; slice < 3; ++slice) {
    cloud.slice_begin.push_back(cloud.size());
    for (int beam = -20; beam <= 20; ++beam) {
      const double pitch = RadFromDeg(-10.0 + 10.0 * slice + 0.01 * beam);
      cloud.positions.emplace_back(3.0, 0.05 * beam, 3.0 * std::tan(pitch));
    }
  }
  return cloud;
}

TEST(SliceLines, AreWhereThePointsAre) {
  const PointCloud cloud = WallScan();
  const auto lines = SliceLines(cloud, {});
  ASSERT_EQ(lines.size(), 3u);
  for (std::size_t s = 0; s < 3; ++s) {
    ASSERT_EQ(lines[s].size(), 1u);
    const SpatialLine& line = lines[s][0];
    EXPECT_LT((line.from_laser - cloud.positions[cloud.slice_begin[s]]).norm(), 2e-3);
    EXPECT_LT((line.to_laser - cloud.positions[cloud.slice_begin[s] + 40]).norm(), 2e-3);
    EXPECT_EQ(line.slice, s);
    EXPECT_EQ(line.points, 41u);
    EXPECT_EQ(line.explained_laser.front(), cloud.positions[cloud.slice_begin[s]]);
  }
}

TEST(SliceLines, DoNotDependOnTheSenseOfTheSweep) {
  PointCloud cloud = WallScan();
  const auto rising = SliceLines(cloud, {});
  for (std::size_t s = 0; s < 3; ++s) {
    const auto begin = cloud.positions.begin() + static_cast<std::ptrdiff_t>(cloud.slice_begin[s]);
    std::reverse(begin, begin + 41);
  }
  const auto falling = SliceLines(cloud, {});
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_LT((rising[s][0].from_laser - falling[s][0].from_laser).norm(), 1e-9);
    EXPECT_LT((rising[s][0].to_laser - falling[s][0].to_laser).norm(), 1e-9);
  }
}

TEST(EdgePointCloud, KeepsTheSlicesAlsoTheEmptyOnes) {
  PointCloud cloud = WallScan();
  cloud.slice_begin = {0, 41, 41, 82};
  const PointCloud edges = EdgePointCloud(cloud, {});
  EXPECT_EQ(edges.slice_begin, (std::vector<std::size_t>{0, 2, 2, 4}));
  ASSERT_EQ(edges.size(), 6u);
  EXPECT_LT(edges.positions[0].y(), edges.positions[1].y());
  EXPECT_TRUE(EdgePointCloud({}, {}).empty());
}

TEST(EdgePointCloud, SaysThatItNeedsSlices) {
  PointCloud cloud = WallScan();
  cloud.slice_begin.clear();
  EXPECT_THAT(ErrorOf([&] { EdgePointCloud(cloud, {}); }),
              testing::HasSubstr("needs the slices of a scan"));
}

}  // namespace
}  // namespace ariadne::slam
