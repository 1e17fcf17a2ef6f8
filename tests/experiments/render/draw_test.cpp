#include "experiments/render/draw.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// How much of the canvas is painted black, in pixels.
double PaintedArea(const Image& canvas) {
  double area = 0.0;
  for (const Rgb& pixel : canvas.pixels) area += 1.0 - pixel.r / 255.0;
  return area;
}

TEST(DrawLine, CoversExactlyTheRowsOfItsWidth) {
  Image canvas(12, 9);
  DrawLine(canvas, {2.0, 4.0}, {10.0, 4.0}, {.width = 2.0});
  EXPECT_EQ(canvas.At(6, 3), kBlack);
  EXPECT_EQ(canvas.At(6, 4), kBlack);
  EXPECT_EQ(canvas.At(6, 2), kWhite);
  EXPECT_EQ(canvas.At(6, 5), kWhite);
}

TEST(DrawLine, IsAntiAliased) {
  Image canvas(12, 9);
  DrawLine(canvas, {2.0, 4.25}, {10.0, 4.25}, {.width = 2.0});
  EXPECT_EQ(canvas.At(6, 4), kBlack);
  EXPECT_NEAR(canvas.At(6, 3).r, 0.25 * 255, 1);
  EXPECT_NEAR(canvas.At(6, 5).r, 0.75 * 255, 1);
}

TEST(DrawLine, HasTheAreaOfItsLengthAndEnds) {
  Image canvas(100, 80);
  DrawLine(canvas, {15.0, 12.0}, {85.0, 63.0}, {.width = 4.0});
  const double length = std::hypot(70.0, 51.0);
  EXPECT_NEAR(PaintedArea(canvas), 4.0 * length + 4.0 * std::numbers::pi, 0.01 * 4.0 * length);
}

TEST(DrawLine, IsCutAtThePictureHoweverLongItIs) {
  Image canvas(20, 20);
  Image expected = canvas;
  DrawLine(canvas, {-1e12, 10.0}, {1e12, 10.0}, {.width = 2.0});
  DrawLine(expected, {-50.0, 10.0}, {50.0, 10.0}, {.width = 2.0});
  EXPECT_EQ(canvas, expected);
  DrawLine(canvas, {-1e12, -1e12}, {-1e11, 1e12}, {.width = 2.0});
  EXPECT_EQ(canvas, expected);
}

TEST(DrawPolylines, PaintsOverlappingPartsOnce) {
  Image canvas(20, 20);
  DrawPolylines(canvas, {{{2, 10}, {18, 10}, {2, 10}}, {{10, 2}, {10, 18}}},
                {.width = 4.0, .opacity = 0.5});
  EXPECT_NEAR(canvas.At(10, 10).r, 128, 1);
  EXPECT_NEAR(canvas.At(5, 10).r, 128, 1);
}

TEST(DrawPolylines, SetsAHaloAroundTheLine) {
  Image canvas(20, 20, kBlack);
  DrawPolylines(canvas, {{{2, 10}, {18, 10}}}, {.color = {200, 0, 0}, .width = 2.0, .halo_width = 2.0});
  EXPECT_EQ(canvas.At(10, 10), (Rgb{200, 0, 0}));
  EXPECT_EQ(canvas.At(10, 11), kWhite);
  EXPECT_EQ(canvas.At(10, 12), kWhite);
  EXPECT_EQ(canvas.At(10, 13), kBlack);
}

TEST(FillCircle, HasItsArea) {
  Image canvas(40, 40);
  FillCircle(canvas, {20.3, 19.8}, 12.0, kBlack);
  EXPECT_NEAR(PaintedArea(canvas), std::numbers::pi * 144.0, 1.5);
  EXPECT_EQ(canvas.At(20, 20), kBlack);
}

TEST(DrawCircle, IsARing) {
  Image canvas(40, 40);
  DrawCircle(canvas, {20, 20}, 12.0, {.width = 3.0});
  EXPECT_NEAR(PaintedArea(canvas), 2.0 * std::numbers::pi * 12.0 * 3.0, 2.0);
  EXPECT_EQ(canvas.At(20, 20), kWhite);
  EXPECT_EQ(canvas.At(32, 20), kBlack);
}

TEST(FillConvexPolygon, DoesNotDependOnTheSense) {
  Image one(30, 30), other(30, 30);
  FillConvexPolygon(one, {{3, 3}, {25, 5}, {10, 27}}, kBlack);
  FillConvexPolygon(other, {{10, 27}, {25, 5}, {3, 3}}, kBlack);
  EXPECT_EQ(one, other);
  EXPECT_NEAR(PaintedArea(one), 0.5 * std::abs(22.0 * 24.0 - 7.0 * 2.0), 2.0);
}

TEST(FillRectangle, FillsWholePixels) {
  Image canvas(6, 6);
  FillRectangle(canvas, {4, 5}, {1, 2}, kBlack);
  EXPECT_EQ(PaintedArea(canvas), 9.0);
  EXPECT_EQ(canvas.At(1, 2), kBlack);
  EXPECT_EQ(canvas.At(3, 4), kBlack);
}

TEST(Draw, RefusesPointsThatAreNotFinite) {
  Image canvas(6, 6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        DrawLine(canvas, {nan, 1}, {2, 2}, {});
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("not finite")));
  EXPECT_THROW(FillCircle(canvas, {1, std::numeric_limits<double>::infinity()}, 2, kBlack), Error);
}

}  // namespace
}  // namespace ariadne::experiments
