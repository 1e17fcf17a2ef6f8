#include "planning/path/footprint.h"

#include <gtest/gtest.h>

#include "tests/planning/path/random_rooms.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

TEST(Footprint, IsFreeWhereTheExactRectangleIs) {
  int free = 0, missed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PillarRoom room = RandomPillarRoom(seed);
    const FreeSpace space(std::span(&room.area, 1));
    RandomStream stream = NamedStream(seed, "test");
    FootprintOptions options;
    options.margin = 0.0;
    options.centre_ahead = 0.1;
    const Footprint footprint(options);
    options.length += 0.05, options.width += 0.05;
    const Footprint larger(options);
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector2d p = DrawAround(room.room, stream);
      const slam::Pose2 pose{DrawUniform(stream, -3.14, 3.14), p};
      if (footprint.IsFree(space, pose)) {
        EXPECT_TRUE(IsRectangleWithin(room.area, footprint.CornersAt(pose))) << seed;
        ++free;
      } else {
        missed += IsRectangleWithin(room.area, larger.CornersAt(pose));
      }
    }
  }
  EXPECT_GT(free, 2000);
  EXPECT_EQ(missed, 0) << "places that are larger by 2.5 cm on each side";
}

TEST(Footprint, KeepsItsMargin) {
  const std::array area{slam::Polygon2{Box(0.0, 0.0, 6.0, 5.0), {}}};
  const FreeSpace space(area);
  const Footprint footprint;
  EXPECT_FALSE(footprint.IsFree(space, {0.0, {3.0, 0.34}}));
  EXPECT_TRUE(footprint.IsFree(space, {0.0, {3.0, 0.375}}));
  EXPECT_FALSE(footprint.IsFree(space, {1.5708, {3.0, 0.44}}));
  EXPECT_TRUE(footprint.IsFree(space, {1.5708, {3.0, 0.475}}));
  EXPECT_FALSE(footprint.IsFree(space, {0.0, {-3.0, 2.0}}));
}

TEST(Footprint, RefusesWhatHasNoSize) {
  FootprintOptions options;
  options.width = 0.0;
  EXPECT_NE(ErrorOf([&] { Footprint footprint(options); }).find("footprint.width"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
