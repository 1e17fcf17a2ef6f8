#include <gmock/gmock.h>

#include "slam/io/occupancy_grid_file.h"
#include "tests/slam/io/other_programs.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::HasSubstr;

/// Three columns, two rows; only the upper left corner is occupied, the lower right one free.
OccupancyGrid SmallGrid() { return {0.05, {-1.5, 2.25}, 3, 2, {0.0F, 0.0F, -0.4F, 0.85F, 0.0F, 0.0F}}; }

TEST(OccupancyGridFile, IsWhatMapServerReads) {
  const TemporaryFolder folder;
  WriteOccupancyGrid(folder / "floor \"1\".pgm", SmallGrid());
  const std::string image = ContentOf(folder / "floor \"1\".pgm");
  const std::string head = "P5\n# ariadne: 0.05 m per pixel\n3 2\n255\n";
  EXPECT_EQ(image, head + std::string("\x00\xcd\xcd\xcd\xcd\xfe", 6));  // the top row first
  EXPECT_EQ(ContentOf(folder / "floor \"1\".yaml"),
            "image: \"floor \\\"1\\\".pgm\"\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2.25, 0.0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(OccupancyGridFile, HasGraysOnTheirSideOfTheThresholds) {
  const auto probability = [](int gray) { return (255 - gray) / 255.0; };  // map_server, negate: 0
  EXPECT_GT(probability(0), 0.65);
  EXPECT_LT(probability(254), 0.196);
  EXPECT_GE(probability(205), 0.196);
  EXPECT_LE(probability(205), 0.65);
}

TEST(OccupancyGridFile, IsReadByNetpbm) {
  ARIADNE_REQUIRE_PROGRAM("pnmfile");
  const TemporaryFolder folder;
  WriteOccupancyGrid(folder / "map.pgm", SmallGrid());
  EXPECT_THAT(OutputOf("pnmfile " + (folder / "map.pgm").string()),
              HasSubstr("PGM raw, 3 by 2  maxval 255"));
}

TEST(OccupancyGridFile, IsRefusedWhereItIsNone) {
  const TemporaryFolder folder;
  const auto error = [&](const char* name, const OccupancyGrid& grid) {
    return ErrorOf([&] { WriteOccupancyGrid(folder / name, grid); });
  };
  EXPECT_THAT(error("map.png", SmallGrid()),
              HasSubstr("map.png: cannot be written: an occupancy grid ends in"));
  EXPECT_THAT(error("a\nb.pgm", SmallGrid()), HasSubstr("control characters"));
  EXPECT_THAT(error("map.pgm", {}), HasSubstr("the grid has 0 x 0 cells, but 0 values"));
  OccupancyGrid torn = SmallGrid();
  torn.log_odds.pop_back();
  EXPECT_THAT(error("map.pgm", torn), HasSubstr("the grid has 3 x 2 cells, but 5 values"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
  if (!fs::exists("/dev/full")) return;
  fs::create_symlink("/dev/full", folder / "full.pgm");
  EXPECT_THAT(error("full.pgm", SmallGrid()), HasSubstr("No space left on device"));
  EXPECT_FALSE(fs::exists(folder / "full.yaml"));
}

}  // namespace
}  // namespace ariadne::slam
