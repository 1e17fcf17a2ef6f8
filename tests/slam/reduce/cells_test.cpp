#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <map>

#include "slam/geometry/box3.h"
#include "slam/reduce/reduce.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;

PointCloud CloudOf(std::vector<Eigen::Vector3d> positions) { return {std::move(positions), {}, {}, {}}; }

PointCloud RandomCloud(std::size_t count) {
  RandomStream stream = NamedStream(1, "cells_test");
  PointCloud cloud = CloudOf(DrawCloud(stream, count, 1.5));
  for (std::size_t i = 0; i < count; ++i) cloud.reflectance.push_back(static_cast<float>(stream() % 256));
  return cloud;
}

using Cell = std::array<int, 3>;

Cell CellOf(const Eigen::Vector3d& p, double edge) {
  const Eigen::Array3i cell = (p.array() / edge).floor().cast<int>();
  return {cell.x(), cell.y(), cell.z()};
}

TEST(ReduceVoxels, MakesTheMeanOfEachCellOfTheGridThroughTheOrigin) {
  const PointCloud cloud = RandomCloud(3000);
  std::map<Cell, std::pair<Eigen::Vector4d, int>> cells;  // sums of position and reflectance; count
  std::vector<Cell> by_appearance;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Cell cell = CellOf(cloud.positions[i], 0.4);
    auto& [sum, count] = cells.try_emplace(cell, Eigen::Vector4d::Zero(), 0).first->second;
    if (count++ == 0) by_appearance.push_back(cell);
    Eigen::Vector4d values;
    values << cloud.positions[i], static_cast<double>(cloud.reflectance[i]);
    sum += values;
  }
  const PointCloud reduced = ReduceVoxels(cloud, 0.4);
  ASSERT_EQ(reduced.size(), by_appearance.size());
  ASSERT_EQ(reduced.reflectance.size(), reduced.size());
  for (std::size_t k = 0; k < reduced.size(); ++k) {
    const auto& [sum, count] = cells.at(by_appearance[k]);
    EXPECT_THAT(reduced.positions[k], NearMatrix(sum.head<3>() / count, 1e-14));
    EXPECT_NEAR(static_cast<double>(reduced.reflectance[k]), sum[3] / count, 1e-4);
  }
}

TEST(ReduceVoxels, HasCellsThatAreOpenAbove) {
  const auto x_of_cells = [](std::vector<double> x_of_points) {
    PointCloud cloud;
    for (const double x : x_of_points) cloud.positions.emplace_back(x, 0.25, 0.25);
    std::vector<double> x;
    for (const Eigen::Vector3d& p : ReduceVoxels(cloud, 0.5).positions) x.push_back(p.x());
    return x;
  };
  EXPECT_THAT(x_of_cells({0.0, 0.25}), ElementsAre(0.125));
  EXPECT_THAT(x_of_cells({0.0, 0.5}), ElementsAre(0.0, 0.5));
  EXPECT_THAT(x_of_cells({-0.125, 0.125}), ElementsAre(-0.125, 0.125));  // no cell twice as wide at 0
  EXPECT_THAT(x_of_cells({-0.5, -0.25}), ElementsAre(-0.375));
  EXPECT_THAT(x_of_cells({-0.5, -0.75}), ElementsAre(-0.5, -0.75));
}

TEST(ReduceVoxels, KeepsDigitsFarFromTheOrigin) {
  const Eigen::Vector3d far(1e5, -2e5, 3e5);
  const PointCloud reduced = ReduceVoxels(
      CloudOf({far + Eigen::Vector3d(0.25, 0.25, 0.25), far + Eigen::Vector3d(0.75, 0.25, 0.25)}), 1.0);
  EXPECT_THAT(reduced.positions, ElementsAre(far + Eigen::Vector3d(0.5, 0.25, 0.25)));
}

TEST(ReduceVoxels, TakesNoLongerForCellsInOnePlane) {
  // Twenty milliseconds; half a minute where the cells of one height collide in the hash table.
  PointCloud floor;
  for (int i = 0; i < 200'000; ++i) floor.positions.emplace_back(i % 500, i / 500, 0.0);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(ReduceVoxels(floor, 1.0).size(), floor.size());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
}

TEST(ReduceVoxels, DropsWhatAMeanDoesNotHave) {
  PointCloud cloud = RandomCloud(10);
  cloud.normals.assign(10, Eigen::Vector3d::UnitZ());
  cloud.slice_begin = {0, 5};
  EXPECT_TRUE(ReduceVoxels(cloud, 10.0).normals.empty());
  EXPECT_FALSE(ReduceVoxels(cloud, 10.0).organized());
}

/// Edge and center of the octree's cube, as 3DTK makes them.
struct OctreeLeaves {
  explicit OctreeLeaves(const PointCloud& cloud, double voxel_size) {
    const Box3 box = BoxAround(cloud.positions);
    center = box.center();
    edge = box.sizes().maxCoeff() + 0.02;
    while (edge > voxel_size) edge *= 0.5;
  }
  Cell LeafOf(const Eigen::Vector3d& p) const { return CellOf(p - center, edge); }
  Eigen::Vector3d center;
  double edge;
};

class ReduceOctreeTo : public testing::TestWithParam<Representative> {};
INSTANTIATE_TEST_SUITE_P(All, ReduceOctreeTo,
                         testing::Values(Representative::kCenter, Representative::kMean,
                                         Representative::kRandom));

TEST_P(ReduceOctreeTo, OnePointPerLeafInTheOrderOfAppearance) {
  const PointCloud cloud = RandomCloud(3000);
  const OctreeLeaves leaves(cloud, 0.3);
  std::vector<Cell> by_appearance;
  for (const Eigen::Vector3d& p : cloud.positions) {
    const Cell leaf = leaves.LeafOf(p);
    if (std::ranges::count(by_appearance, leaf) == 0) by_appearance.push_back(leaf);
  }
  const PointCloud reduced = ReduceOctree(cloud, 0.3, GetParam(), 7);
  ASSERT_EQ(reduced.size(), by_appearance.size());
  EXPECT_EQ(reduced.reflectance.size(), reduced.size());
  for (std::size_t k = 0; k < reduced.size(); ++k) {
    EXPECT_EQ(leaves.LeafOf(reduced.positions[k]), by_appearance[k]);
  }
}

TEST(ReduceOctree, HalvesTheBoundingCubeUntilALeafIsSmallEnough) {
  // The cube is 1.02 m wide, 1 m and a margin of 1 cm on each side, around (0.5, 0, 0).
  const PointCloud cloud = CloudOf({{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  const auto centers = [&](double size) {
    return ReduceOctree(cloud, size, Representative::kCenter, 1).positions;
  };
  EXPECT_THAT(centers(2.0).size(), 2u) << "the cells begin at the center of the cube";
  EXPECT_THAT(centers(0.5), ElementsAre(NearMatrix(Eigen::Vector3d(0.1175, 0.1275, 0.1275), 1e-15),
                                        NearMatrix(Eigen::Vector3d(0.8825, 0.1275, 0.1275), 1e-15)));
  EXPECT_EQ(centers(0.1).size(), 3u);
}

TEST(ReduceOctree, TakesTheMeanOfALeaf) {
  const PointCloud cloud = CloudOf({{0.0, 0.1, 0.0}, {0.1, 0.2, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_THAT(ReduceOctree(cloud, 0.5, Representative::kMean, 1).positions,
              ElementsAre(NearMatrix(Eigen::Vector3d(0.05, 0.15, 0.0), 1e-15),
                          NearMatrix(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-15)));
}

TEST(ReduceOctree, DrawsEachPointOfALeafAlikeAndAlwaysTheSameByItsSeed) {
  PointCloud cloud = CloudOf({{0.01, 0.01, 0.01}, {0.02, 0.02, 0.02}, {0.03, 0.03, 0.03}, {5.0, 5.0, 5.0}});
  cloud.reflectance = {0.0F, 1.0F, 2.0F, 3.0F};
  std::array<int, 3> drawn{};
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const PointCloud reduced = ReduceOctree(cloud, 1.0, Representative::kRandom, seed);
    ASSERT_EQ(reduced.size(), 2u);
    const auto chosen = static_cast<std::size_t>(reduced.reflectance[0]);
    EXPECT_EQ(reduced.positions[0], cloud.positions[chosen]);
    ++drawn.at(chosen);
    EXPECT_EQ(ReduceOctree(cloud, 1.0, Representative::kRandom, seed).positions, reduced.positions);
  }
  for (const int count : drawn) EXPECT_NEAR(count, 1000, 100);  // 4 sigma
}

TEST(ReduceOctree, OfEqualPointsIsOne) {
  const PointCloud cloud = CloudOf(std::vector<Eigen::Vector3d>(5, {1.0, 2.0, 3.0}));
  EXPECT_THAT(ReduceOctree(cloud, 0.1, Representative::kMean, 1).positions,
              ElementsAre(NearMatrix(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-14)));
  EXPECT_TRUE(ReduceOctree({}, 0.1, Representative::kMean, 1).empty());
  EXPECT_TRUE(ReduceVoxels({}, 0.1).empty());
}

TEST(ReduceCells, SaysWhatIsWrongWithCoordinates) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    const PointCloud cloud = CloudOf({{1.0, 2.0, 3.0}, {1.0, bad, 3.0}});
    EXPECT_EQ(ErrorOf([&] { ReduceVoxels(cloud, 0.1); }), "point 1 is not finite");
    EXPECT_EQ(ErrorOf([&] { ReduceOctree(cloud, 0.1, Representative::kMean, 1); }),
              "point 1 is not finite");
  }
  const std::string too_small =
      "reduce.voxel_size is too small for coordinates this large: at most 2^20 cells to each side";
  EXPECT_EQ(ErrorOf([&] { ReduceVoxels(CloudOf({{1048576.0, 0.0, 0.0}}), 1.0); }), too_small);
  EXPECT_EQ(ErrorOf([&] { ReduceVoxels(CloudOf({{0.0, 0.0, -1e9}}), 1.0); }), too_small);
  EXPECT_EQ(ReduceVoxels(CloudOf({{1048575.0, -1048575.0, 0.0}}), 1.0).size(), 1u);
}

}  // namespace
}  // namespace ariadne::slam
