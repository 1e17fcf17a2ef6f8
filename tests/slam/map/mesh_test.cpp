#include <gmock/gmock.h>

#include <map>
#include <set>

#include "slam/map/voxel_mesh.h"
#include "tests/support/error_of.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

using ::testing::HasSubstr;
using Place = std::array<long, 3>;

/// Six times the volume that the triangles enclose: positive where they look outwards.
double SixVolumes(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return sum;
}

/// The edges, by place, that are passed more often one way than the other.
std::size_t OpenEdges(const TriangleMesh& mesh, double grid) {
  const auto place = [&](std::uint32_t v) {
    const Eigen::Vector3d p = mesh.vertices[v] / grid;
    return Place{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())};
  };
  std::map<std::pair<Place, Place>, int> passed;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Place from = place(triangle[i]), to = place(triangle[(i + 1) % 3]);
      if (from < to) ++passed[{from, to}];
      if (to < from) --passed[{to, from}];
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(passed, [](const auto& e) { return e.second != 0; }));
}

std::vector<OctreeCell> RandomCells(std::uint64_t seed, std::size_t points) {
  RandomStream stream = NamedStream(seed, "mesh_test");
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    cloud.positions.push_back(DrawInBox(stream, {-0.5, -0.3, 0.0}, {0.5, 0.4, 0.6}));
    cloud.reflectance.push_back(static_cast<float>(i));
  }
  Octree tree({.leaf_size = 0.1});
  tree.Add(cloud, Eigen::Vector3d::Zero());
  return tree.Cells(100);
}

TEST(VoxelMesh, EnclosesTheVoxelsWithoutHoles) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<OctreeCell> cells = RandomCells(seed, 20 + 20 * seed);
    const TriangleMesh mesh = VoxelMesh(cells, {});
    EXPECT_NEAR(SixVolumes(mesh) / 6.0, static_cast<double>(cells.size()) * 1e-3, 1e-9);
    EXPECT_EQ(OpenEdges(mesh, 0.05), 0U);
    EXPECT_EQ(mesh.colors.size(), mesh.vertices.size());
  }
}

TEST(VoxelMesh, LeavesOutFacesBetweenNeighbours) {
  OctreeCell cell{.center = {0.5, 0.5, 0.5}, .edge = 1.0, .count = 1};
  std::vector<OctreeCell> cells{cell};
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 12U);
  EXPECT_EQ(VoxelMesh(cells, {}).vertices.size(), 8U);
  cell.center.x() += 1.0;
  cells.push_back(cell);
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 20U);
  cell.center = {0.75, 0.25, 1.25};  // of another size, on top
  cell.edge = 0.5;
  cells.push_back(cell);
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 32U);
  EXPECT_TRUE(VoxelMesh({}, {}).triangles.empty());
  cells[0].center.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { VoxelMesh(cells, {}); }), HasSubstr("no place"));
}

TEST(VoxelMesh, ColorsByReflectanceOrHeight) {
  const OctreeCell low{.center = {0, 0, 0}, .edge = 0.1, .count = 1, .reflectance = 9};
  OctreeCell high = low, middle = low;
  high.center.z() = 2.0;
  high.reflectance = 1.0F;
  middle.center.z() = 1.0;
  middle.reflectance = std::numeric_limits<float>::quiet_NaN();
  const std::vector<OctreeCell> cells{low, middle, high};
  const TriangleMesh grey = VoxelMesh(cells, {VoxelColoring::kReflectance});
  EXPECT_EQ(grey.colors.front(), (Rgb{255, 255, 255}));
  EXPECT_EQ(grey.colors[8], (Rgb{128, 128, 128}));
  EXPECT_EQ(grey.colors.back(), (Rgb{0, 0, 0}));
  const TriangleMesh rainbow = VoxelMesh(cells, {VoxelColoring::kHeight});
  EXPECT_EQ(rainbow.colors.front(), (Rgb{0, 0, 255}));
  EXPECT_EQ(rainbow.colors[8], (Rgb{0, 255, 0}));
  EXPECT_EQ(rainbow.colors.back(), (Rgb{255, 0, 0}));
}

}  // namespace
}  // namespace ariadne::slam
