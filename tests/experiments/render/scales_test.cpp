#include "experiments/render/scales.h"

#include <gmock/gmock.h>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr Rgb kInk{30, 30, 30};

TEST(RoundNumberBelow, IsOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(RoundNumberBelow(1.99), 1.0);
  EXPECT_DOUBLE_EQ(RoundNumberBelow(2.0), 2.0);
  EXPECT_DOUBLE_EQ(RoundNumberBelow(49.0), 20.0);
  EXPECT_DOUBLE_EQ(RoundNumberBelow(0.07), 0.05);
  EXPECT_DOUBLE_EQ(RoundNumberBelow(1000.0), 1000.0);
  EXPECT_THROW(RoundNumberBelow(0.0), Error);
}

/// The longest run of ink in any row, in pixels.
int LongestRun(const Image& image, int first_row) {
  int longest = 0;
  for (int y = first_row; y < image.height; ++y) {
    int run = 0;
    for (int x = 0; x < image.width; ++x) {
      run = image.At(x, y) == kInk ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST(ScaleBar, HasTheLengthThatItSays) {
  // 400 px at 10 px/m: a quarter is 10 m, so the bar is 10 m or 100 px.
  const Camera camera = TopView({400, 100}, Up::kPlusY, {0, 0, 0}, 10.0);
  const Image picture(400, 100);
  const Image barred = WithScaleBar(picture, camera);
  EXPECT_EQ(Cropped(barred, 0, 0, 400, 100), picture);
  EXPECT_NEAR(LongestRun(barred, 100), 100, 3);
  Image inside(400, 100, {0, 120, 0});
  DrawScaleBar(inside, camera);
  EXPECT_NEAR(LongestRun(inside, 0), 100, 3);
}

TEST(ScaleBar, IsRefusedInPerspective) {
  EXPECT_THAT(
      [] {
        WithScaleBar(Image(400, 100), ObliqueView({0, 0, 0}));
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("perspective")));
}

TEST(ColorBar, RunsFromLowToHigh) {
  const Image barred = WithColorBar(Image(400, 100), ColorMap::kSea, {0.0, 2.5}, "height [m]");
  const int y = 100 + static_cast<int>(1.2 * 0.018 * 400);
  EXPECT_EQ(barred.At(40, y), ColorAt(ColorMap::kSea, 0.5 / 200));
  EXPECT_EQ(barred.At(239, y), ColorAt(ColorMap::kSea, 199.5 / 200));
  EXPECT_EQ(barred.At(38, y), kWhite);
}

}  // namespace
}  // namespace ariadne::experiments
