#include <gmock/gmock.h>
#include <octomap/OcTree.h>

#include <limits>
#include <memory>
#include <set>
#include <tuple>

#include "slam/io/octomap_file.h"
#include "tests/slam/io/other_programs.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

/// A wall at x = 3 as the laser sees it, which stands at (1, 0, 1) and is turned by 90 deg to the left: in
/// the map the wall is at y = 3, and x goes from -0.5 to 2.5.
PosedCloud ScanOfWall() {
  PosedCloud scan;
  scan.name = "wall";
  for (int i = 0; i <= 60; ++i) {
    for (int k = 0; k <= 20; ++k) scan.cloud_laser.positions.emplace_back(3.0, -1.5 + 0.05 * i, 0.05 * k);
  }
  scan.T_map_laser.rotation = Eigen::AngleAxisd(0.5 * 3.14159265358979, Eigen::Vector3d::UnitZ());
  scan.T_map_laser.translation = {1.0, 0.0, 1.0};
  return scan;
}

/// The cells of the smallest size that are occupied, by their keys.
std::set<std::tuple<int, int, int>> OccupiedCells(octomap::OcTree& tree) {
  tree.expand();
  std::set<std::tuple<int, int, int>> cells;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeKey key = leaf.getKey();
    if (tree.isNodeOccupied(*leaf)) cells.emplace(key[0], key[1], key[2]);
  }
  return cells;
}

/// Reads either format with OctoMap's own readers.
std::unique_ptr<octomap::OcTree> Read(const fs::path& path) {
  if (path.extension() == ".bt") return std::make_unique<octomap::OcTree>(path.string());
  std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read(path.string()));
  return std::unique_ptr<octomap::OcTree>(dynamic_cast<octomap::OcTree*>(tree.release()));
}

/// What follows the header, which has a free comment.
std::string Data(const fs::path& path) {
  const std::string content = ContentOf(path);
  return content.substr(content.find("\nid OcTree\n"));
}

std::set<std::tuple<int, int, int>> ExpectedCells(const PosedCloud& scan, const octomap::OcTree& tree) {
  std::set<std::tuple<int, int, int>> cells;
  for (const Eigen::Vector3d& p_laser : scan.cloud_laser.positions) {
    const Eigen::Vector3f p = (scan.T_map_laser * p_laser).cast<float>();
    const octomap::OcTreeKey key = tree.coordToKey(octomap::point3d(p.x(), p.y(), p.z()));
    cells.emplace(key[0], key[1], key[2]);
  }
  return cells;
}

TEST(OctoMap, IsReadByOctoMap) {
  const TemporaryFolder folder;
  const PosedCloud scan = ScanOfWall();
  for (const char* name : {"map.bt", "map.ot"}) {
    WriteOctoMap(folder / name, {&scan, 1}, {.resolution = 0.1});
    const auto tree = Read(folder / name);
    ASSERT_NE(tree, nullptr);
    EXPECT_EQ(tree->getResolution(), 0.1);
    EXPECT_EQ(OccupiedCells(*tree), ExpectedCells(scan, *tree));
    const octomap::OcTreeNode* const between = tree->search(1.0, 1.5, 1.25);
    ASSERT_NE(between, nullptr);
    EXPECT_FALSE(tree->isNodeOccupied(between));
    EXPECT_EQ(tree->search(1.0, 3.4, 1.5), nullptr);  // behind the wall
    EXPECT_EQ(tree->search(1.0, -0.5, 1.0), nullptr);
  }
}

TEST(OctoMap, LetsPointsOutvoteBeams) {
  const TemporaryFolder folder;
  const PosedCloud wall = ScanOfWall();
  PosedCloud far = wall;  // goes through the wall: one scan against one
  for (Eigen::Vector3d& p : far.cloud_laser.positions) p *= 2.0;
  const std::vector<PosedCloud> scans{far, wall, wall, far};
  WriteOctoMap(folder / "map.ot", scans, {.resolution = 0.1});
  const auto tree = Read(folder / "map.ot");
  EXPECT_TRUE(tree->isNodeOccupied(tree->search(1.0, 3.0, 1.5)));
  const std::vector<PosedCloud> gone{wall, far, far, far};
  WriteOctoMap(folder / "gone.ot", gone, {.resolution = 0.1});
  const auto later = Read(folder / "gone.ot");
  EXPECT_FALSE(later->isNodeOccupied(later->search(1.0, 3.0, 1.5)));
}

TEST(OctoMap, CutsLongBeams) {
  const TemporaryFolder folder;
  const PosedCloud scan = ScanOfWall();
  WriteOctoMap(folder / "map.bt", {&scan, 1}, {.resolution = 0.1, .max_range = 2.0});
  const auto tree = Read(folder / "map.bt");
  EXPECT_TRUE(OccupiedCells(*tree).empty());
  EXPECT_NE(tree->search(1.0, 1.5, 1.25), nullptr);
  EXPECT_EQ(tree->search(1.0, 2.5, 1.25), nullptr);
}

TEST(OctoMap, IsReadByItsTools) {
  ARIADNE_REQUIRE_PROGRAM("convert_octree");
  ARIADNE_REQUIRE_PROGRAM("bt2vrml");
  const TemporaryFolder folder;
  const PosedCloud scan = ScanOfWall();
  WriteOctoMap(folder / "map.bt", {&scan, 1}, {.resolution = 0.1});
  WriteOctoMap(folder / "map.ot", {&scan, 1}, {.resolution = 0.1});
  OutputOf("convert_octree " + (folder / "map.ot").string() + " " + (folder / "read.bt").string());
  EXPECT_EQ(OccupiedCells(*Read(folder / "read.bt")), OccupiedCells(*Read(folder / "map.bt")));
  EXPECT_EQ(Data(folder / "read.bt"), Data(folder / "map.bt"));
  OutputOf("bt2vrml " + (folder / "map.bt").string());
  EXPECT_THAT(ContentOf(folder / "map.bt.wrl"), HasSubstr("#VRML V2.0 utf8"));
}

TEST(OctoMap, HasTheSameBytesAgainAndPrintsNothing) {
  const TemporaryFolder folder;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::vector<PosedCloud> scans{ScanOfWall(), ScanOfWall()};
  for (const char* extension : {".bt", ".ot"}) {
    WriteOctoMap(folder / (std::string("a") + extension), scans);
    WriteOctoMap(folder / (std::string("b") + extension), scans);
    EXPECT_EQ(ContentOf(folder / (std::string("a") + extension)),
              ContentOf(folder / (std::string("b") + extension)));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

TEST(OctoMap, RefusesWhatItCannotHold) {
  const TemporaryFolder folder;
  const fs::path path = folder.Write("map.bt", "old");
  const auto error = [&](const PosedCloud& scan) {
    return ErrorOf([&] { WriteOctoMap(path, {&scan, 1}, {.resolution = 0.01}); });
  };
  EXPECT_EQ(error({}), path.string() + ": cannot be written: the scans have no points");
  EXPECT_THAT(ErrorOf([&] { WriteOctoMap(folder / "map.txt", {}); }), HasSubstr("ends in .bt"));
  PosedCloud scan = ScanOfWall();
  scan.cloud_laser.positions[3].x() = 400.0;
  EXPECT_THAT(error(scan), HasSubstr("scan 'wall' has a place at (2.5"));
  EXPECT_THAT(error(scan), HasSubstr("finite and within 327.67 m of the origin, or the cells larger"));
  scan.cloud_laser.positions[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error(scan), HasSubstr("has a place at"));
  scan = ScanOfWall();
  scan.T_map_laser.translation.x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error(scan), HasSubstr("has a place at (inf, 0, 1) m"));
  EXPECT_THAT(ErrorOf([&] {
                WriteOctoMap(path, {&scan, 1}, {.resolution = 0.0});
              }),
              HasSubstr("octomap.resolution is 0 m, but must be in 0.001 to 10"));
  EXPECT_EQ(ContentOf(path), "old");
  if (!fs::exists("/dev/full")) return;
  fs::create_symlink("/dev/full", folder / "full.ot");
  scan = ScanOfWall();
  EXPECT_THAT(ErrorOf([&] {
                WriteOctoMap(folder / "full.ot", {&scan, 1});
              }),
              HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace ariadne::slam
