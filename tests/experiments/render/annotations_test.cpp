#include "experiments/render/annotations.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam/base/error.h"
#include "tests/experiments/render/colors.h"

namespace ariadne::experiments {
namespace {

Image Picture() { return {400, 100, kMidGray}; }

bool HasInk(const Image& band) {
  return std::any_of(band.pixels.begin(), band.pixels.end(), [](Rgb pixel) { return pixel.r < 100; });
}

TEST(Annotations, TitleStandsAboveAndCaptionBelow) {
  const Image titled = WithTitle(Picture(), "Top view");
  const int band = titled.height - 100;
  EXPECT_EQ(titled.width, 400);
  EXPECT_EQ(Cropped(titled, 0, band, 400, 100), Picture());
  EXPECT_TRUE(HasInk(Cropped(titled, 0, 0, 400, band)));
  const Image captioned = WithCaption(Picture(), "before");
  EXPECT_EQ(Cropped(captioned, 0, 0, 400, 100), Picture());
  EXPECT_TRUE(HasInk(Cropped(captioned, 0, 100, 400, captioned.height - 100)));
}

TEST(Annotations, ALongTitleShrinksUntilItFits) {
  const Image titled = WithTitle(Picture(), std::string(200, 'M'));
  for (int y = 0; y < titled.height - 100; ++y) {
    EXPECT_EQ(titled.At(0, y), kWhite);
    EXPECT_EQ(titled.At(399, y), kWhite);
  }
}

TEST(Annotations, LegendShowsEveryColorInRowsThatFit) {
  std::vector<LegendEntry> entries{{"scan 0", kRed}, {"scan 1", kBlue}};
  const Image short_legend = WithLegend(Picture(), entries);
  EXPECT_GT(std::count(short_legend.pixels.begin(), short_legend.pixels.end(), kRed), 30);
  EXPECT_GT(std::count(short_legend.pixels.begin(), short_legend.pixels.end(), kBlue), 30);
  entries.resize(30, {"scan n", kMidGray});
  const Image long_legend = WithLegend(Picture(), entries);
  EXPECT_GT(long_legend.height, short_legend.height);
  EXPECT_EQ(long_legend.width, 400);
  EXPECT_EQ(WithLegend(Picture(), {}), Picture());
}

TEST(Annotations, LettersFollowTheOptions) {
  const Image small = WithTitle(Picture(), "a", {.cap_height = 10});
  const Image large = WithTitle(Picture(), "a", {.cap_height = 20});
  EXPECT_NEAR(large.height - 100, 2 * (small.height - 100), 2);
  EXPECT_THROW(WithTitle(Image(), "a"), Error);
}

TEST(Stacked, NeedsEqualWidths) {
  EXPECT_EQ(Stacked(Image(5, 2, kRed), Image(5, 1, kBlue)).At(4, 2), kBlue);
  EXPECT_THROW(Stacked(Image(5, 2), Image(6, 2)), Error);
}

}  // namespace
}  // namespace ariadne::experiments
