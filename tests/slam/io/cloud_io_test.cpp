#include "slam/io/cloud_io.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

TEST(CloudFormat, IsToldFromTheName) {
  EXPECT_EQ(FormatFromPath("a/scan.3d"), CloudFormat::kUos);
  EXPECT_EQ(FormatFromPath("SCAN.PLY"), CloudFormat::kPly);
  EXPECT_EQ(FormatFromPath("a.txt"), CloudFormat::kXyz);
  EXPECT_EQ(FormatFromExtension("a.pose"), std::nullopt);
  EXPECT_THAT(ErrorOf([] { FormatFromPath("a.las"); }),
              HasSubstr("a.las: the extension does not tell the format"));
  EXPECT_EQ(FormatFromName("kitti"), CloudFormat::kKitti);
  EXPECT_EQ(NameOf(CloudFormat::kPcd), "pcd");
  EXPECT_THAT(ErrorOf([] { FormatFromName("UOS"); }),
              HasSubstr("named 'UOS'; use uos, xyz, ply, pcd or kitti"));
  EXPECT_EQ(EncodingFromName("binary_compressed"), CloudEncoding::kBinaryCompressed);
  EXPECT_THAT(ErrorOf([] { EncodingFromName("zip"); }), HasSubstr("named 'zip'"));
}

TEST(CloudIo, WritesAndReadsEveryFormatAndEncoding) {
  const TemporaryFolder folder;
  PointCloud cloud = SmallCloud();
  cloud.reflectance = {0.5F, 17.0F, 255.0F};
  for (const char* name : {"a.3d", "a.xyz", "a.ply", "a.pcd", "a.bin"}) {
    for (const auto encoding :
         {CloudEncoding::kAscii, CloudEncoding::kBinary, CloudEncoding::kBinaryCompressed}) {
      const fs::path path = folder / name;
      if (!CanEncode(FormatFromPath(path), encoding)) {
        EXPECT_THAT(ErrorOf([&] { WriteCloud(path, cloud, encoding); }), HasSubstr("has no such encoding"));
        continue;
      }
      WriteCloud(path, cloud, encoding);
      ExpectEqual(ReadCloud(path).cloud, cloud);
    }
    WriteCloud(folder / name, cloud);
    ExpectEqual(ReadCloud(folder / name).cloud, cloud);
  }
}

TEST(CloudIo, InfersSlicesWhereTheFileHasNone) {
  PointCloud cloud;
  for (int row = 0; row < 5; ++row) {
    for (int beam = 0; beam <= 18; ++beam) {
      const double angle = 0.1 + 0.16 * beam;
      const double pitch = 0.05 * row;
      cloud.positions.emplace_back(std::sin(angle) * std::cos(pitch), -std::cos(angle),
                                   std::sin(angle) * std::sin(pitch));
    }
  }
  const TemporaryFolder folder;
  for (const char* name : {"a.xyz", "a.ply"}) {
    WriteCloud(folder / name, cloud);
    EXPECT_THAT(ReadCloud(folder / name).cloud.slice_begin, testing::ElementsAre(0, 19, 38, 57, 76))
        << name;
  }
}

TEST(CloudIo, CountsDroppedPoints) {
  const TemporaryFolder folder;
  const fs::path path =
      folder.Write("a.pcd",
                   "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n"
                   "POINTS 2\nDATA ascii\n1 2 3\nnan nan nan\n");
  EXPECT_EQ(ReadCloud(path).dropped, 1U);
  EXPECT_EQ(ReadCloud(path).cloud.size(), 1U);
}

TEST(CloudIo, NamesTheFileInItsSentences) {
  const TemporaryFolder folder;
  const fs::path path = folder.Write("a.xyz", "1 2 x\n");
  EXPECT_EQ(ErrorOf([&] { ReadCloud(path); }), path.string() + ":1: 'x' is not a number");
  EXPECT_THAT(ErrorOf([&] { ReadCloud(folder.path(), CloudFormat::kUos); }), HasSubstr("is a folder"));
}

TEST(CloudIo, SaysThatTheDiskIsFull) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "map.ply");
  EXPECT_THAT(ErrorOf([&] { WriteCloud(folder / "map.ply", SmallCloud()); }),
              HasSubstr("map.ply: cannot be written: No space left on device"));
}

}  // namespace
}  // namespace ariadne::slam
