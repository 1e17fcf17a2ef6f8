#include "experiments/render/text.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "experiments/render/glyphs.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// First and last column and row that are not white.
struct Extent {
  int left = 1000, right = -1, top = 1000, bottom = -1;
};

Extent InkExtent(const Image& image) {
  Extent extent;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.At(x, y) == kWhite) continue;
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = std::max(extent.bottom, y);
    }
  }
  return extent;
}

Image Written(const std::string& text, Align align = Align::kLeft) {
  Image image(400, 60);
  DrawText(image, {200, 40}, text, {.cap_height = 20}, align);
  return image;
}

TEST(Text, EveryCharacterHasItsOwnShape) {
  std::set<std::string> shapes;
  for (char c = ' '; c <= '~'; ++c) {
    const Image image = Written(std::string(1, c));
    shapes.insert({reinterpret_cast<const char*>(image.pixels.data()), 3 * image.pixels.size()});
  }
  EXPECT_EQ(shapes.size(), 95U);
}

TEST(Text, GlyphsStayWithinTheirBox) {
  for (char c = '!'; c <= '~'; ++c) {
    const Glyph glyph = GlyphOf(static_cast<unsigned char>(c));
    EXPECT_FALSE(glyph.strokes.empty()) << c;
    for (const Polyline& stroke : glyph.strokes) {
      for (const Eigen::Vector2d& p : stroke) {
        EXPECT_TRUE(p.x() >= -0.2 && p.x() <= glyph.width + 0.2 && p.y() >= -2.0 && p.y() <= 7.0) << c;
      }
    }
  }
}

TEST(Text, KnowsTheGreekLettersOfFormulas) {
  std::set<std::size_t> inks{0};
  for (const char* letter : {"\u03b1", "\u03b2", "\u03b3", "\u03b8", "\u03c6", "\u03c9", "\u03b4"}) {
    const Image image = Written(letter);
    const auto white = std::count(image.pixels.begin(), image.pixels.end(), kWhite);
    inks.insert(image.pixels.size() - static_cast<std::size_t>(white));
  }
  EXPECT_EQ(inks.size(), 8U) << "no two are alike, and delta is the box";
  EXPECT_EQ(Written("\u03b4"), Written("\x01"));
  EXPECT_EQ(TextWidth("\u03c9x", {}), TextWidth("wx", {})) << "six units wide, as w";
}

TEST(Text, CurvesAreRound) {
  const Glyph glyph = GlyphOf(U'o');
  double reach = 0.0;
  for (const Eigen::Vector2d& p : glyph.strokes.at(0)) {
    const double radius = (p - Eigen::Vector2d(2.0, 2.0)).norm();
    EXPECT_NEAR(radius, 2.0, 0.15) << "two units around the middle of the letter";
    reach = std::max(reach, p.x());
  }
  EXPECT_EQ(reach, 4.0);
}

TEST(Text, CapitalsStandOnTheBaselineAndAreCapHeightHigh) {
  const Extent extent = InkExtent(Written("H"));
  const double half_stroke = 0.5 * 0.13 * 20;
  EXPECT_NEAR(extent.bottom + 1, 40 + half_stroke, 1.0);
  EXPECT_NEAR(extent.top, 20 - half_stroke, 1.0);
}

TEST(Text, WidthIsThatOfTheInk) {
  const Extent extent = InkExtent(Written("Hall 13"));
  EXPECT_NEAR(extent.left, 200, 1.0);
  EXPECT_NEAR(extent.right + 1, 200 + TextWidth("Hall 13", {.cap_height = 20}), 1.0);
  EXPECT_EQ(TextWidth("", {}), 0.0);
}

TEST(Text, AlignsAtTheAnchor) {
  const Extent centered = InkExtent(Written("HOH", Align::kCenter));
  EXPECT_NEAR(0.5 * (centered.left + centered.right + 1), 200, 1.0);
  EXPECT_NEAR(InkExtent(Written("HOH", Align::kRight)).right + 1, 200, 1.0);
}

TEST(Text, ShowsABoxForWhatItDoesNotHave) {
  EXPECT_EQ(Written("\xC3\xA9"), Written("\x01")) << "two bytes of UTF-8 are one character";
  EXPECT_NE(Written("\x01"), Written(" "));
}

TEST(Text, RefusesLettersWithoutHeight) {
  Image image(10, 10);
  EXPECT_THROW(DrawText(image, {0, 0}, "a", {.cap_height = 0.0}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
