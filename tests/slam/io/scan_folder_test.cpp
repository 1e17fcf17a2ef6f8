#include "slam/io/scan_folder.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

class ScanFolderTest : public testing::Test {
 protected:
  ScanFolderTest() {
    for (int i = 0; i < 3; ++i) {
      folder_.Write("scan" + std::to_string(i) + ".xyz", std::to_string(i) + " 0 0\n");
    }
  }
  TemporaryFolder folder_;
};

TEST_F(ScanFolderTest, ReadsScansAndPoses) {
  folder_.Write("poses.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n");
  const ScanFolder read = ReadScanFolder(folder_.path());
  ASSERT_EQ(read.scans.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.scans[i].name, "scan" + std::to_string(i));
    EXPECT_EQ(read.scans[i].cloud_laser.positions.front().x(), static_cast<double>(i));
    EXPECT_EQ(read.scans[i].T_map_laser.translation.x(), static_cast<double>(i));
  }
  EXPECT_THAT(read.notes, ElementsAre("initial poses are from " + (folder_ / "poses.txt").string()));
}

TEST_F(ScanFolderTest, SaysThatThereAreNoPoses) {
  const ScanFolder read = ReadScanFolder(folder_.path());
  EXPECT_EQ(read.scans[2].T_map_laser.translation, Eigen::Vector3d::Zero());
  EXPECT_THAT(read.notes, ElementsAre(HasSubstr("all start from identity")));
}

TEST_F(ScanFolderTest, ReadsARangeWithItsPosesAndReportsProgress) {
  folder_.Write("poses.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n");
  std::vector<std::string> progress;
  ScanFolderOptions options;
  options.first = 1;
  options.on_progress = [&](const std::string& name, std::size_t done, std::size_t total) {
    progress.push_back(name + " " + std::to_string(done) + "/" + std::to_string(total));
  };
  const ScanFolder read = ReadScanFolder(folder_.path(), options);
  ASSERT_EQ(read.scans.size(), 2U);
  EXPECT_EQ(read.scans[0].T_map_laser.translation.x(), 1.0);
  EXPECT_THAT(progress, ElementsAre("scan1 0/2", "scan2 1/2"));
  options.last = 1;
  EXPECT_EQ(ReadScanFolder(folder_.path(), options).scans.size(), 1U);
}

TEST_F(ScanFolderTest, RefusesRangesBeyondTheEnd) {
  for (const auto& [first, last] :
       std::vector<std::pair<std::size_t, std::size_t>>{{0, 3}, {3, 3}, {2, 1}}) {
    ScanFolderOptions options;
    options.first = first;
    options.last = last;
    EXPECT_THAT(ErrorOf([&] { ReadScanFolder(folder_.path(), options); }),
                HasSubstr("the folder has scans 0 to 2"));
  }
}

TEST_F(ScanFolderTest, NotesDroppedPoints) {
  folder_.Write(
      "pcd/scan0.pcd",
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
      "1 2 3\nnan nan nan\n");
  EXPECT_THAT(ReadScanFolder(folder_ / "pcd").notes,
              testing::Contains("scan0: 1 points without a measurement were dropped"));
}

}  // namespace
}  // namespace ariadne::slam
