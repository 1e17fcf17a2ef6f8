#include "slam/io/scan_list.h"

#include <gmock/gmock.h>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> Names(const ScanList& list) {
  std::vector<std::string> names;
  for (const ScanFile& scan : list.scans) names.push_back(scan.name);
  return names;
}

TEST(NaturallyBefore, ComparesNumbersAsNumbers) {
  EXPECT_TRUE(NaturallyBefore("scan2", "scan10"));
  EXPECT_FALSE(NaturallyBefore("scan10", "scan2"));
  EXPECT_TRUE(NaturallyBefore("scan009", "scan10"));
  EXPECT_TRUE(NaturallyBefore("a1b2", "a1b10"));
  EXPECT_TRUE(NaturallyBefore("a", "a1"));
  EXPECT_TRUE(NaturallyBefore("1", "a"));
  EXPECT_TRUE(NaturallyBefore("scan00", "scan1"));
  EXPECT_NE(NaturallyBefore("scan01", "scan1"), NaturallyBefore("scan1", "scan01"));
  EXPECT_FALSE(NaturallyBefore("scan1", "scan1"));
  EXPECT_TRUE(NaturallyBefore("99999999999999999999998", "99999999999999999999999"));
}

TEST(ListScans, ListsInNaturalOrder) {
  const TemporaryFolder folder;
  for (const char* name :
       {"scan10.3d", "scan2.3d", "scan1.3d", "scan1.pose", "README.txt", "poses.txt", "._scan1.3d"}) {
    folder.Write(name, "");
  }
  const ScanList list = ListScans(folder.path());
  EXPECT_THAT(Names(list), ElementsAre("scan1", "scan2", "scan10"));
  EXPECT_EQ(list.format, CloudFormat::kUos);
  EXPECT_EQ(list.scans[1].path, folder / "scan2.3d");
}

TEST(ListScans, TakesNumberedTextsAsScans) {
  const TemporaryFolder folder;
  for (const char* name : {"scan0.txt", "scan1.txt", "SOURCE.txt"}) folder.Write(name, "");
  EXPECT_THAT(Names(ListScans(folder.path())), ElementsAre("scan0", "scan1"));
  EXPECT_THAT(Names(ListScans(folder.path(), CloudFormat::kXyz)), ElementsAre("scan0", "scan1"));
}

TEST(ListScans, GoesIntoTheOnlySubfolderWithScans) {
  const TemporaryFolder folder;
  folder.Write("README.txt", "");
  folder.Write("pcd/scan000.pcd", "");
  folder.Write("pictures/photo.png", "");
  EXPECT_EQ(ListScans(folder.path()).folder, folder / "pcd");
  folder.Write("more/scan000.pcd", "");
  EXPECT_THAT(ErrorOf([&] { ListScans(folder.path()); }),
              HasSubstr("holds no scans, but 2 of its folders do"));
}

TEST(ListScans, AsksForTheFormatOfMixedFolders) {
  const TemporaryFolder folder;
  folder.Write("scan0.3d", "");
  folder.Write("scan0.ply", "");
  EXPECT_THAT(ErrorOf([&] { ListScans(folder.path()); }), HasSubstr("say which to take with --format"));
  EXPECT_EQ(ListScans(folder.path(), CloudFormat::kPly).scans.front().path, folder / "scan0.ply");
  EXPECT_THAT(ErrorOf([&] { ListScans(folder.path(), CloudFormat::kPcd); }),
              HasSubstr("holds no scans of the format pcd"));
}

TEST(ListScans, SaysWhatIsNoFolderOfScans) {
  const TemporaryFolder folder;
  EXPECT_THAT(ErrorOf([&] { ListScans(folder.path()); }), HasSubstr("holds no scans (.3d, .xyz"));
  EXPECT_THAT(ErrorOf([&] { ListScans(folder / "none"); }), HasSubstr("none: there is no such folder"));
  EXPECT_THAT(ErrorOf([&] { ListScans(folder.Write("scan0.3d", "")); }),
              HasSubstr("scan0.3d: is not a folder"));
}

}  // namespace
}  // namespace ariadne::slam
