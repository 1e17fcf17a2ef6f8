#include "experiments/render/point_view.h"

#include <gmock/gmock.h>

#include <limits>

#include "experiments/render/disc_radii.h"
#include "experiments/render/draw_splats.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/experiments/render/colors.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Looks along +x of the map, 100 px per rad near the middle.
Camera Ahead() { return LookAt({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 1.2, {200, 150}); }

/// Discs of 5 px without shading or smoothing.
PointViewOptions Plain() {
  return {.splats = {.noise = 0.0, .min_radius = 5.0}, .eye_dome = {.strength = 0.0}, .supersampling = 1};
}

TEST(PointView, NearPointsHideFarOnesInAnyOrder) {
  const ColoredPoints near_first{{{2, 0, 0}, {6, 0, 0}}, {kRed, kBlue}};
  const ColoredPoints far_first{{{6, 0, 0}, {2, 0, 0}}, {kBlue, kRed}};
  const Image image = RenderPoints(near_first, Ahead(), Plain());
  EXPECT_EQ(image.At(100, 75), kRed);
  EXPECT_EQ(RenderPoints(far_first, Ahead(), Plain()), image);
}

TEST(PointView, PointsAreRoundSplatsOfTheirColorAtTheirPlace) {
  const Camera camera = Ahead();
  const Image image = RenderPoints({{{5, 1, 0.5}}, {kRed}}, camera, Plain());
  const ImagePoint center = Projector(camera)({5, 1, 0.5});
  int painted = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double distance = std::hypot(x + 0.5 - center.u, y + 0.5 - center.v);
      EXPECT_EQ(image.At(x, y), distance <= 5.0 ? kRed : kWhite) << x << " " << y;
      painted += distance <= 5.0 ? 1 : 0;
    }
  }
  EXPECT_NEAR(painted, 78.5, 6.0);
}

TEST(PointView, RadiusInTheMapShrinksWithDistance) {
  PointViewOptions options = Plain();
  options.splats = {.radius = 0.1, .noise = 0.0, .min_radius = 0.5, .max_radius = 100.0};
  const auto area = [&](double x) {
    const Image image = RenderPoints({{{x, 0, 0}}, {kRed}}, Ahead(), options);
    return static_cast<double>(std::count(image.pixels.begin(), image.pixels.end(), kRed));
  };
  EXPECT_NEAR(area(1.0) / area(2.0), 4.0, 0.4);
}

TEST(PointView, ScansOfOneSurfaceBlend) {
  const ColoredPoints points{{{2, 0, 0}, {2.01, 0, 0}}, {kRed, kBlue}};
  PointViewOptions options = Plain();
  const Rgb blended = RenderPoints(points, Ahead(), options).At(100, 75);
  EXPECT_NEAR(blended.r, 100, 5);
  EXPECT_NEAR(blended.b, 100, 5);
}

TEST(PointView, DoesNotSeeBehindTheCamera) {
  EXPECT_EQ(RenderPoints({{{-2, 0, 0}, {0, 0, 0}}, {kRed, kRed}}, Ahead()), Image(200, 150));
}

TEST(PointView, LeavesNoHolesInASurface) {
  ColoredPoints wall;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) wall.positions_map.emplace_back(3.0, -1.5 + 0.05 * i, -1.5 + 0.05 * j);
  }
  wall.colors.assign(wall.positions_map.size(), kRed);
  const Image image = RenderPoints(wall, Ahead());
  for (int y = 50; y < 100; ++y) {
    for (int x = 70; x < 130; ++x) ASSERT_EQ(image.At(x, y), kRed) << x << " " << y;
  }
}

TEST(PointView, IsDeterministic) {
  RandomStream stream = NamedStream(5, "cloud");
  ColoredPoints points;
  for (int i = 0; i < 3000; ++i) {
    points.positions_map.emplace_back(DrawUniform(stream, 1, 8), DrawUniform(stream, -4, 4),
                                      DrawUniform(stream, -2, 2));
    points.colors.push_back(CategoricalColor(static_cast<std::size_t>(i) % 7));
  }
  const Image image = RenderPoints(points, Ahead());
  EXPECT_EQ(RenderPoints(points, Ahead()), image);
  EXPECT_NE(image, Image(200, 150));
}

TEST(PointView, NoPointsAreAnEmptyPicture) {
  EXPECT_EQ(RenderPoints({}, Ahead(), {.background = kBlue}), Image(200, 150, kBlue));
}

TEST(PointView, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        RenderPoints({{{nan, 0, 0}}, {kRed}}, Ahead());
      },
      ThrowsMessage<Error>(HasSubstr("not finite")));
  EXPECT_THAT([] { RenderPoints({}, Ahead(), {.supersampling = 0}); },
              ThrowsMessage<Error>(HasSubstr("supersampling")));
  PointViewOptions options;
  options.splats.min_radius = 9.0;
  EXPECT_THAT([&] { RenderPoints({}, Ahead(), options); }, ThrowsMessage<Error>(HasSubstr("min_radius")));
}

TEST(DrawSplats, AreHiddenByWhatTheFrameHolds) {
  Frame frame(Ahead(), kWhite);
  const std::vector<Splat> splats = ProjectSplats({{{5, 0, 0}}, {kRed}}, Ahead(), {.min_radius = 3.0});
  const std::size_t middle = frame.color.IndexOf(100, 75);
  frame.depth[middle] = 4.0F;
  frame.color.pixels[middle] = kBlue;
  DrawSplats(frame, splats);
  EXPECT_EQ(frame.color.pixels[middle], kBlue);
  EXPECT_EQ(frame.color.At(101, 75), kRed);
  EXPECT_FLOAT_EQ(frame.depth[frame.color.IndexOf(101, 75)], 5.0F);
}

TEST(DrawSplats, CrossTheBordersOfTiles) {
  const Camera camera = TopView({200, 150}, Up::kPlusY, {0, 0, 0}, 10.0);
  Frame frame(camera, kWhite);
  DrawSplats(frame,
             {{.u = 60.0F, .v = 60.0F, .depth = 1.0F, .radius = 10.0F, .grain = 0.1F, .color = kRed}});
  for (const auto& [x, y] : {std::pair{53, 53}, {66, 53}, {53, 66}, {66, 66}}) {
    EXPECT_EQ(frame.color.At(x, y), kRed) << x << " " << y;
  }
}

TEST(DiscRadii, AreLargerWhereFewerPointsShareASurface) {
  std::vector<Eigen::Vector3d> points{{100, 100, 100}};
  for (int i = 0; i < 400; ++i) points.emplace_back(0.0125 * (i % 20), 0.0125 * (i / 20), 0.1);
  for (int i = 0; i < 25; ++i) points.emplace_back(10.0 + 0.05 * (i % 5), 0.05 * (i / 5), 0.1);
  const std::vector<float> radii = DiscRadii(points);
  EXPECT_NEAR(radii[1], 0.0125 * 0.85, 0.002);
  EXPECT_NEAR(radii.back(), 0.05 * 0.85, 0.01);
  EXPECT_LT(radii[0], radii.back()) << "a point alone is no surface";
}

}  // namespace
}  // namespace ariadne::experiments
