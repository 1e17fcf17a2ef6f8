#include "slam/map/octree.h"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>
#include <numeric>

#include "slam/geometry/angles.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using ::testing::HasSubstr;

constexpr OctreeOptions kOptions{.leaf_size = 0.1};

/// Points on the walls of a box with some noise, in random order.
PointCloud DrawWalls(std::uint64_t seed, std::size_t count) {
  RandomStream stream = NamedStream(seed, "octree_test");
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p = DrawInBox(stream, {-2.0, -1.5, -0.3}, {3.0, 2.5, 2.2});
    const auto side = static_cast<int>(stream() % 6);
    p[side / 2] =
        (side % 2 == 0 ? Eigen::Vector3d(-2.0, -1.5, -0.3) : Eigen::Vector3d(3.0, 2.5, 2.2))[side / 2];
    p[side / 2] += DrawNormal(stream, 0.0, 0.01);
    cloud.positions.push_back(p);
    cloud.reflectance.push_back(static_cast<float>(DrawUniform(stream, 0.0, 255.0)));
  }
  return cloud;
}

PointCloud CloudOf(std::vector<Eigen::Vector3d> points) {
  PointCloud cloud;
  cloud.positions = std::move(points);
  return cloud;
}

/// The statistics of a cell, without any trick.
struct Reference {
  std::uint64_t count = 0;
  Eigen::Matrix<long double, 3, 1> sum = Eigen::Matrix<long double, 3, 1>::Zero();
  Eigen::Matrix<long double, 3, 3> squares = Eigen::Matrix<long double, 3, 3>::Zero();
  long double reflectance = 0.0L;

  Eigen::Matrix<long double, 3, 1> Mean() const { return sum / static_cast<long double>(count); }
  Eigen::Matrix3d Covariance() const {
    return (squares / static_cast<long double>(count) - Mean() * Mean().transpose()).cast<double>();
  }
};

bool IsIn(const OctreeCell& cell, const Eigen::Vector3d& p) {
  return ((p - cell.center).array().abs() <= 0.5 * cell.edge + 1e-9).all();
}

TEST(Octree, KnowsCountMeanNormalAndReflectanceOfEachCell) {
  const PointCloud cloud_map = DrawWalls(1, 20000);
  Octree tree(kOptions);
  tree.Add(cloud_map, {0.5, 0.5, 1.0});
  EXPECT_EQ(tree.points(), cloud_map.size());
  for (int depth = 0; depth <= tree.max_depth() + 1; ++depth) {
    const std::vector<OctreeCell> cells = tree.Cells(depth);
    const double edge = cells.front().edge;
    EXPECT_NEAR(edge, kOptions.leaf_size * std::exp2(std::max(0, tree.max_depth() - depth)), 1e-12);
    const Eigen::Vector3d corner = cells.front().center - Eigen::Vector3d::Constant(0.5 * edge);
    const auto index = [&](const Eigen::Vector3d& p) {
      const Eigen::Array3i i =
          ((p - corner) / edge + Eigen::Vector3d::Constant(1e-9)).array().floor().cast<int>();
      return std::array{i.x(), i.y(), i.z()};
    };
    std::map<std::array<int, 3>, Reference> references;
    for (std::size_t i = 0; i < cloud_map.size(); ++i) {
      Reference& reference = references[index(cloud_map.positions[i])];
      const Eigen::Matrix<long double, 3, 1> p = cloud_map.positions[i].cast<long double>();
      ++reference.count;
      reference.sum += p;
      reference.squares += p * p.transpose();
      reference.reflectance += cloud_map.reflectance[i];
    }
    ASSERT_EQ(cells.size(), references.size()) << depth;
    for (const OctreeCell& cell : cells) {
      const Reference& reference = references.at(index(cell.center));
      ASSERT_EQ(cell.count, reference.count);
      ASSERT_TRUE(IsIn(cell, cell.mean));
      ASSERT_LT((cell.mean - reference.Mean().cast<double>()).norm(), 1e-6 * kOptions.leaf_size);
      ASSERT_NEAR(cell.reflectance,
                  static_cast<double>(reference.reflectance) / static_cast<double>(cell.count), 1e-3);
      if (cell.normal.isZero()) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(reference.Covariance());
      const Eigen::Vector3d& variances = axes.eigenvalues();
      const double across = cell.normal.dot(reference.Covariance() * cell.normal);
      ASSERT_NEAR(across, variances[0], 1e-4 * variances[2]);
      ASSERT_NEAR(cell.normal.norm(), 1.0, 1e-9);
    }
  }
}

TEST(Octree, BoundsAllAtDepthZero) {
  Octree tree(kOptions);
  EXPECT_TRUE(tree.Cells(0).empty());
  EXPECT_TRUE(tree.CellsIn(Box3(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()), 3).empty());
  const PointCloud cloud_map = DrawWalls(2, 500);
  tree.Add(cloud_map, Eigen::Vector3d::Zero());
  const std::vector<OctreeCell> root = tree.Cells(0);
  ASSERT_EQ(root.size(), 1U);
  EXPECT_EQ(root[0].count, cloud_map.size());
  for (const Eigen::Vector3d& p : cloud_map.positions) EXPECT_TRUE(IsIn(root[0], p));
  EXPECT_LT(root[0].edge, 2.0 * (5.1 + kOptions.leaf_size));
  EXPECT_EQ(tree.Cells(tree.max_depth()).size(), tree.leaves());
}

TEST(Octree, HasOneLeafForOnePoint) {
  Octree tree(kOptions);
  tree.Add(CloudOf({{-0.05, 0.0, 0.1}}), Eigen::Vector3d::Zero());
  EXPECT_EQ(tree.max_depth(), 0);
  const OctreeCell cell = tree.Cells(0).at(0);
  EXPECT_TRUE(cell.center.isApprox(Eigen::Vector3d(-0.05, 0.05, 0.15)));
  EXPECT_TRUE(cell.mean.isApprox(Eigen::Vector3d(-0.05, 0.0, 0.1), 1e-8));
  EXPECT_TRUE(cell.normal.isZero());
}

TEST(Octree, FindsTheCellsOfABox) {
  Octree tree(kOptions);
  tree.Add(DrawWalls(3, 5000), Eigen::Vector3d::Zero());
  RandomStream stream = NamedStream(3, "boxes");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d low = DrawInBox(stream, {-4.0, -3.0, -2.0}, {3.0, 2.0, 2.0});
    const Eigen::Vector3d size =
        DrawInBox(stream, {0.0, 0.0, 0.0},
                  i % 2 == 0 ? Eigen::Vector3d(4.0, 4.0, 4.0) : Eigen::Vector3d(0.3, 0.3, 0.3));
    const Box3 box_map(low, low + size);
    const int depth = i % (tree.max_depth() + 2);
    std::vector<Eigen::Vector3d> expected, found;
    for (const OctreeCell& cell : tree.Cells(depth)) {
      const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * cell.edge);
      if (Box3(cell.center - half, cell.center + half).intersects(box_map)) expected.push_back(cell.mean);
    }
    for (const OctreeCell& cell : tree.CellsIn(box_map, depth)) found.push_back(cell.mean);
    EXPECT_EQ(found, expected) << depth;
  }
  EXPECT_TRUE(tree.CellsIn(Box3(), 2).empty());
  const double infinity = std::numeric_limits<double>::infinity();
  const Box3 all(Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity));
  EXPECT_EQ(tree.CellsIn(all, 4).size(), tree.Cells(4).size());
}

TEST(Octree, DoesNotDependOnTheOrderBeyondRounding) {
  const std::vector<PointCloud> clouds{DrawWalls(4, 4000), DrawWalls(5, 4000), DrawWalls(6, 4000)};
  const std::vector<Eigen::Vector3d> viewpoints{{0.0, 0.0, 1.0}, {2.0, 1.0, 1.0}, {-1.0, -1.0, 0.5}};
  Octree forwards(kOptions), backwards(kOptions);
  for (std::size_t i = 0; i < 3; ++i) {
    forwards.Add(clouds[i], viewpoints[i]);
    PointCloud reversed = clouds[2 - i];
    std::ranges::reverse(reversed.positions);
    std::ranges::reverse(reversed.reflectance);
    backwards.Add(reversed, viewpoints[2 - i]);
  }
  for (const int depth : {0, 3, 100}) {
    const std::vector<OctreeCell> a = forwards.Cells(depth), b = backwards.Cells(depth);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i].center, b[i].center);
      ASSERT_EQ(a[i].count, b[i].count);
      ASSERT_LT((a[i].mean - b[i].mean).norm(), 1e-6 * kOptions.leaf_size);
      ASSERT_NEAR(a[i].reflectance, b[i].reflectance, 1e-4 * 255.0);
      if (a[i].count <= 10) continue;
      ASSERT_LT((a[i].normal - b[i].normal).norm(), 1e-2);
    }
  }
}

TEST(Octree, IsTheSameInAShiftedFrame) {
  const PointCloud cloud_map = DrawWalls(7, 3000);
  const Eigen::Vector3d shift = kOptions.leaf_size * Eigen::Vector3d(-12345.0, 777.0, 31.0);
  PointCloud shifted = cloud_map;
  for (Eigen::Vector3d& p : shifted.positions) p += shift;
  Octree here(kOptions), there(kOptions);
  here.Add(cloud_map, Eigen::Vector3d::Zero());
  there.Add(shifted, shift);
  const std::vector<OctreeCell> a = here.Cells(4), b = there.Cells(4);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].count, b[i].count);
    ASSERT_LT((a[i].mean + shift - b[i].mean).norm(), 1e-9);
  }
}

TEST(Octree, MeansStayExactOverManyVisits) {
  RandomStream stream = NamedStream(8, "visits");
  Octree tree(kOptions);
  Eigen::Matrix<long double, 3, 1> sum = Eigen::Matrix<long double, 3, 1>::Zero();
  constexpr int kVisits = 1000000;
  PointCloud
      cloud_map;  // each point of the leaf at 40 m comes after one elsewhere, and is stored by itself
  for (int i = 0; i < kVisits; ++i) {
    cloud_map.positions.push_back(DrawInBox(stream, {40.0, 0.0, 0.0}, {40.099, 0.099, 0.099}));
    cloud_map.positions.emplace_back(0.01, 0.01, 0.01);
    sum += cloud_map.positions[2 * i].cast<long double>();
  }
  tree.Add(cloud_map, Eigen::Vector3d::Zero());
  const OctreeCell cell = tree.Cells(100).back();
  ASSERT_EQ(cell.count, kVisits);
  EXPECT_LT((cell.mean - (sum / kVisits).cast<double>()).norm(), 1e-5 * kOptions.leaf_size);
}

TEST(Octree, NormalsLookToTheNearestViewpoint) {
  PointCloud floor;
  for (int i = 0; i < 900; ++i) floor.positions.emplace_back(0.01 * (i % 30), 0.01 * (i / 30), 0.05);
  Octree tree(kOptions);
  tree.Add(floor, {0.1, 0.1, -3.0});
  for (const OctreeCell& cell : tree.Cells(100))
    EXPECT_LT((cell.normal + Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  tree.Add(floor, {0.1, 0.1, 2.0});
  tree.Add(floor, {0.1, 0.1, -4.0});
  for (const OctreeCell& cell : tree.Cells(100))
    EXPECT_LT((cell.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-6);
}

TEST(ViewCode, KeepsTheDirectionToADegree) {
  RandomStream stream = NamedStream(9, "directions");
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d direction = DrawDirection(stream);
    const Eigen::Vector3d kept = ViewDirection(ViewCode(7.0 * direction));
    EXPECT_LT(std::acos(std::min(1.0, kept.dot(direction))), RadFromDeg(1.0)) << direction.transpose();
  }
  EXPECT_LT(ViewCode({0.0, 0.0, 2.0}), ViewCode({0.0, 2.1, 0.0}));
}

TEST(Octree, MemoryGrowsWithTheSurfaceAlone) {
  const PointCloud cloud_map = DrawWalls(10, 20000);
  Octree tree(kOptions);
  tree.Add(cloud_map, Eigen::Vector3d::Zero());
  const std::size_t bytes = tree.bytes();
  EXPECT_GT(bytes, tree.leaves() * 48);
  EXPECT_LT(bytes, tree.leaves() * 80);
  for (int i = 0; i < 10; ++i) tree.Add(cloud_map, Eigen::Vector3d::Zero());
  EXPECT_EQ(tree.bytes(), bytes);
  EXPECT_EQ(tree.points(), 11 * cloud_map.size());
}

TEST(Octree, CopiesAreTheirOwn) {
  Octree tree(kOptions);
  tree.Add(DrawWalls(11, 100), Eigen::Vector3d::Zero());
  Octree copy = tree;
  copy.Add(DrawWalls(12, 100), Eigen::Vector3d::Zero());
  EXPECT_EQ(tree.Cells(0)[0].count, 100U);
  EXPECT_EQ(copy.Cells(0)[0].count, 200U);
}

TEST(Octree, HasReflectanceWhereAllCloudsHaveIt) {
  PointCloud with = DrawWalls(13, 10);
  PointCloud without = with;
  without.reflectance.clear();
  for (const bool first : {true, false}) {
    Octree tree(kOptions);
    tree.Add(first ? with : without, Eigen::Vector3d::Zero());
    EXPECT_EQ(tree.has_reflectance(), first);
    tree.Add({}, Eigen::Vector3d::Zero());
    EXPECT_EQ(tree.has_reflectance(), first);
    tree.Add(first ? without : with, Eigen::Vector3d::Zero());
    EXPECT_FALSE(tree.has_reflectance());
    EXPECT_EQ(tree.Cells(0)[0].reflectance, 0.0F);
  }
}

TEST(Octree, RefusesWhatItCannotHold) {
  Octree tree(kOptions);
  tree.Add(DrawWalls(14, 10), Eigen::Vector3d::Zero());
  const auto error_of = [&](const Eigen::Vector3d& p) {
    return ErrorOf([&] { tree.Add(CloudOf({{0.0, 0.0, 0.0}, p}), Eigen::Vector3d::Zero()); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_of({0.0, nan, 0.0}), HasSubstr("point 1"));
  EXPECT_THAT(error_of({0.0, nan, 0.0}), HasSubstr("NaN or infinite"));
  EXPECT_THAT(error_of({0.0, 0.0, -std::numeric_limits<double>::infinity()}), HasSubstr("NaN or infinite"));
  EXPECT_THAT(error_of({1.1e5, 0.0, 0.0}), HasSubstr("104858 m from the origin"));
  EXPECT_THAT(error_of({0.0, 1e300, 0.0}), HasSubstr("octree.leaf_size"));
  EXPECT_THAT(ErrorOf([&] { tree.Add({}, {nan, 0.0, 0.0}); }), HasSubstr("viewpoint"));
  PointCloud uneven = CloudOf({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
  uneven.reflectance = {1.0F};
  EXPECT_THAT(ErrorOf([&] { tree.Add(uneven, {0.0, 0.0, 0.0}); }), HasSubstr("2 points, but 1"));
  EXPECT_THAT(ErrorOf([&] { tree.Cells(-1); }), HasSubstr("0 or more"));
  EXPECT_EQ(tree.points(), 10U);
  EXPECT_THAT(ErrorOf([] { Octree({.leaf_size = 0.0}); }), HasSubstr("octree.leaf_size"));
  const double edge = 104857.0;  // within the lattice
  tree.Add(CloudOf({{edge, edge, edge}, {-edge, -edge, -edge}}), Eigen::Vector3d::Zero());
  EXPECT_EQ(tree.max_depth(), 21);
  EXPECT_EQ(tree.Cells(0).at(0).count, 12U);
  EXPECT_EQ(tree.Cells(21).size(), tree.leaves());
}

}  // namespace
}  // namespace ariadne::slam
