#include "experiments/render/density_view.h"

#include <gmock/gmock.h>

#include <limits>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kScale = 50.0;  // [px/m]

Camera TopOfWall() { return TopView({200, 120}, Up::kPlusY, {0, 0, 0}, kScale); }

/// A wall along x, 2.5 m high, seen with the noise of a scanner, and a floor around it.
ColoredPoints WallAt(double y, Rgb color, double sigma = 0.008) {
  RandomStream stream = NamedStream(3, "wall");
  ColoredPoints points;
  for (int i = 0; i < 8000; ++i) {
    points.positions_map.emplace_back(DrawUniform(stream, -1.8, 1.8), y + DrawNormal(stream, 0.0, sigma),
                                      DrawUniform(stream, 0.0, 2.5));
    points.positions_map.emplace_back(DrawUniform(stream, -1.8, 1.8), DrawUniform(stream, -1.0, 1.0), 0.0);
  }
  points.colors.assign(points.positions_map.size(), color);
  return points;
}

ColoredPoints Union(ColoredPoints a, const ColoredPoints& b) {
  a.positions_map.insert(a.positions_map.end(), b.positions_map.begin(), b.positions_map.end());
  a.colors.insert(a.colors.end(), b.colors.begin(), b.colors.end());
  return a;
}

/// Mean darkness of each row, 0 (white) to 1.
std::vector<double> RowDarkness(const Image& image) {
  std::vector<double> rows;
  for (int y = 0; y < image.height; ++y) {
    double sum = 0.0;
    for (int x = 40; x < 160; ++x)
      sum += 1.0 - (image.At(x, y).r + image.At(x, y).g + image.At(x, y).b) / 765.0;
    rows.push_back(sum / 120.0);
  }
  return rows;
}

/// Dark rows with lighter ones on both sides: how many walls a reader sees.
int CountRidges(const Image& image) {
  const std::vector<double> rows = RowDarkness(image);
  const double threshold = 0.5 * *std::max_element(rows.begin(), rows.end());
  int ridges = 0;
  for (std::size_t y = 1; y < rows.size(); ++y)
    ridges += rows[y - 1] < threshold && rows[y] >= threshold ? 1 : 0;
  return ridges;
}

TEST(DensityView, ASingleWallIsOneRidgeWhereItStands) {
  const Image image = RenderDensity(WallAt(0.4, kBlack), TopOfWall());
  EXPECT_EQ(CountRidges(image), 1);
  const std::vector<double> rows = RowDarkness(image);
  const auto darkest = std::max_element(rows.begin(), rows.end()) - rows.begin();
  EXPECT_NEAR(static_cast<double>(darkest) + 0.5, 60 - 0.4 * kScale, 1.0);
}

TEST(DensityView, ADoubleWallIsTwoRidges) {
  const ColoredPoints doubled = Union(WallAt(0.4, kBlack), WallAt(0.5, kBlack));
  EXPECT_EQ(CountRidges(RenderDensity(doubled, TopOfWall())), 2);
  const ColoredPoints matched = Union(WallAt(0.4, kBlack), WallAt(0.4, kBlack));
  EXPECT_EQ(CountRidges(RenderDensity(matched, TopOfWall())), 1);
}

TEST(DensityView, WallsAreDarkerThanFloorsHitAsOften) {
  const std::vector<double> rows = RowDarkness(RenderDensity(WallAt(0.4, kBlack), TopOfWall()));
  EXPECT_GT(rows[40], 0.6);
  EXPECT_LT(rows[70], 0.2);
  EXPECT_GT(rows[70], 0.001);
}

TEST(DensityView, CountsPointsWhereColumnsAreOff) {
  ColoredPoints points{{{0, 0, 0}}, {kBlack}};
  for (int i = 0; i < 50; ++i) points.positions_map.emplace_back(1.01, 0.01, 0.0);
  points.colors.assign(points.positions_map.size(), kBlack);
  points.positions_map[0] = {0.01, 0.01, 0.0};
  const Image image = RenderDensity(points, TopOfWall(), {.column = 0.0, .reference_share = 1.0});
  EXPECT_LT(image.At(150, 59).r, 10);
  EXPECT_GT(image.At(100, 59).r, 150);
}

TEST(DensityView, HueIsTheMeanOfTheScans) {
  const Rgb red{220, 40, 40}, blue{40, 40, 220};
  const ColoredPoints points{{{0.01, 0.01, 0}, {0.01, 0.01, 0}, {1.01, 0.01, 0}}, {red, blue, red}};
  const Image image = RenderDensity(points, TopOfWall(), {.reference_share = 0.0, .darkest = 1.0});
  EXPECT_EQ(image.At(150, 59), red);
  EXPECT_EQ(image.At(100, 59), Mix(red, blue, 0.5));
}

TEST(DensityView, APointBetweenPixelsIsShared) {
  const ColoredPoints points{{{0.0, 0.01, 0}}, {kBlack}};
  const Image image = RenderDensity(points, TopOfWall());
  EXPECT_EQ(image.At(99, 59), image.At(100, 59));
  EXPECT_NE(image.At(99, 59), kWhite);
  EXPECT_EQ(image.At(101, 59), kWhite);
  EXPECT_NE(RenderDensity(points, TopOfWall(), {.pen_radius = 2.0}).At(101, 59), kWhite);
}

TEST(DensityView, IsDeterministicAndIgnoresPointsOutside) {
  ColoredPoints points = WallAt(0.4, kBlack);
  const Image image = RenderDensity(points, TopOfWall());
  EXPECT_EQ(RenderDensity(points, TopOfWall()), image);
  points.positions_map.emplace_back(1e12, -1e12, 1.0);
  points.colors.push_back(kBlack);
  EXPECT_EQ(RenderDensity(points, TopOfWall()), image);
}

TEST(DensityView, NoPointsAreAnEmptyPicture) { EXPECT_EQ(RenderDensity({}, TopOfWall()), Image(200, 120)); }

TEST(DensityView, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        RenderDensity({{{0, nan, 0}}, {kBlack}}, TopOfWall());
      },
      ThrowsMessage<Error>(HasSubstr("not finite")));
  EXPECT_THAT(
      [] {
        RenderDensity({}, ObliqueView({0, 0, 0}));
      },
      ThrowsMessage<Error>(HasSubstr("orthographic")));
  EXPECT_THAT([] { RenderDensity({}, TopOfWall(), {.pen_radius = 0.5}); },
              ThrowsMessage<Error>(HasSubstr("pen_radius")));
}

}  // namespace
}  // namespace ariadne::experiments
