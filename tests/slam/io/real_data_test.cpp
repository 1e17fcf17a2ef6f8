// The real scans that come with the project's data, where they are there.
#include <gmock/gmock.h>

#include <array>
#include <set>

#include "slam/io/scan_folder.h"
#include "slam/io/uos_axes.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;

TEST(RealData, Hallway) {
  const fs::path folder = DataFolder() / "scans/hallway";
  ARIADNE_REQUIRE_DATA(folder);
  const ScanFolder read = ReadScanFolder(folder);
  ASSERT_EQ(read.scans.size(), 3U);
  for (const PosedCloud& scan : read.scans) {
    EXPECT_EQ(scan.cloud_laser.size(), 81360U);
    ASSERT_EQ(scan.cloud_laser.slice_begin.size(), 226U);
    for (std::size_t row = 0; row < 226; ++row) EXPECT_EQ(scan.cloud_laser.slice_begin[row], 360 * row);
  }
  EXPECT_TRUE(read.scans[1].T_map_laser.translation.isApprox(
      Eigen::Vector3d(1.56917, 0.0310605, -0.0750803), 1e-12));
  EXPECT_TRUE(ToUosPose(read.scans[2].T_map_laser)
                  .euler_deg.isApprox(Eigen::Vector3d(1.11333, -0.470508, -0.479231), 1e-9));
}

/// Share of the points of scan001 that have one of scan000 in their cell of 20 cm.
double Overlap(const std::vector<PosedCloud>& scans, const Pose3& T_map_laser1) {
  const auto cell = [](const Eigen::Vector3d& p) {
    const Eigen::Array3i index = (p.array() / 0.2).floor().cast<int>();
    return std::array{index.x(), index.y(), index.z()};
  };
  std::set<std::array<int, 3>> cells;
  for (const Eigen::Vector3d& p : scans[0].cloud_laser.positions) cells.insert(cell(p));
  std::size_t hits = 0;
  for (const Eigen::Vector3d& p : scans[1].cloud_laser.positions) {
    hits += cells.count(cell(T_map_laser1 * p));
  }
  return static_cast<double>(hits) / static_cast<double>(scans[1].cloud_laser.size());
}

TEST(RealData, HallwayPosesLayScansOnEachOther) {
  const fs::path folder = DataFolder() / "scans/hallway";
  ARIADNE_REQUIRE_DATA(folder);
  ScanFolderOptions options;
  options.last = 1;
  const std::vector<PosedCloud> scans = ReadScanFolder(folder, options).scans;
  const double with_pose = Overlap(scans, scans[1].T_map_laser);
  EXPECT_GT(with_pose, 0.8);
  EXPECT_GT(with_pose, Overlap(scans, Pose3()) + 0.1);
  EXPECT_GT(with_pose, Overlap(scans, scans[1].T_map_laser.Inverse()) + 0.1);
}

TEST(RealData, Garage) {
  const fs::path folder = DataFolder() / "scans/garage13";
  ARIADNE_REQUIRE_DATA(folder);
  const ScanFolder read = ReadScanFolder(folder);
  ASSERT_EQ(read.scans.size(), 13U);
  std::size_t points = 0;
  for (const PosedCloud& scan : read.scans) {
    points += scan.cloud_laser.size();
    EXPECT_EQ(scan.cloud_laser.reflectance.size(), scan.cloud_laser.size());
  }
  EXPECT_EQ(points, 1'067'827U);
  EXPECT_EQ(read.scans[0].cloud_laser.reflectance[0], 52.0F);
  EXPECT_EQ(read.scans[12].name, "scan012");
  EXPECT_TRUE(
      read.scans[0].T_map_laser.translation.isApprox(Eigen::Vector3d(-6.06303, -8.2396, 0.0), 1e-12));
  EXPECT_THAT(read.notes, testing::Contains(testing::HasSubstr("initial_poses.txt")));
}

TEST(RealData, RoomsOfPcl) {
  const fs::path folder = DataFolder() / "scans/pcl_rooms";
  ARIADNE_REQUIRE_DATA(folder);
  const ScanFolder read = ReadScanFolder(folder);
  ASSERT_EQ(read.scans.size(), 2U);
  EXPECT_EQ(read.scans[0].cloud_laser.size(), 112'586U);
  EXPECT_EQ(read.scans[1].cloud_laser.size(), 112'624U);
  EXPECT_THAT(read.notes, testing::ElementsAre(testing::HasSubstr("start from identity")));
}

}  // namespace
}  // namespace ariadne::slam
