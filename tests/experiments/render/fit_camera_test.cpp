#include "experiments/render/fit_camera.h"

#include <gmock/gmock.h>

#include <limits>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

std::vector<Eigen::Vector3d> PointsInBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                                         int count) {
  RandomStream stream = NamedStream(1, "points");
  std::vector<Eigen::Vector3d> points{low, high};
  for (int i = 0; i < count; ++i) {
    points.emplace_back(DrawUniform(stream, low.x(), high.x()), DrawUniform(stream, low.y(), high.y()),
                        DrawUniform(stream, low.z(), high.z()));
  }
  return points;
}

struct PixelBox {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

PixelBox Projected(const Camera& camera, const std::vector<Eigen::Vector3d>& points) {
  PixelBox box;
  const Projector project(camera);
  for (const Eigen::Vector3d& p : points) {
    const ImagePoint point = project(p);
    EXPECT_TRUE(project.InFront(point.depth));
    box.left = std::min(box.left, point.u);
    box.right = std::max(box.right, point.u);
    box.top = std::min(box.top, point.v);
    box.bottom = std::max(box.bottom, point.v);
  }
  return box;
}

TEST(Fitted, TopViewFillsThePictureWithinMargins) {
  const auto points = PointsInBox({-3, 1, 0}, {17, 6, 2}, 500);
  const Camera camera = Fitted(TopView({1000, 600}), points, {.outlier_share = 0.0, .margin = 50});
  EXPECT_NEAR(camera.scale, 900.0 / 20.0, 1e-9);
  const PixelBox box = Projected(camera, points);
  EXPECT_NEAR(box.left, 50, 1e-6);
  EXPECT_NEAR(box.right, 950, 1e-6);
  EXPECT_NEAR(0.5 * (box.top + box.bottom), 300, 1e-6);
}

TEST(Fitted, PerspectiveShowsAllAndTouchesASide) {
  const auto points = PointsInBox({-3, 1, 0}, {17, 6, 2}, 500);
  for (const double azimuth : {-2.0, 0.3, 1.5}) {
    const Camera start = ObliqueView({0, 0, 0}, {.azimuth = azimuth, .size = {1000, 600}});
    const PixelBox box = Projected(Fitted(start, points, {.outlier_share = 0.0, .margin = 50}), points);
    EXPECT_GE(box.left, 50 - 1e-6);
    EXPECT_LE(box.right, 950 + 1e-6);
    EXPECT_GE(box.top, 50 - 1e-6);
    EXPECT_LE(box.bottom, 550 + 1e-6);
    EXPECT_TRUE(box.right - box.left > 900 - 1e-6 || box.bottom - box.top > 500 - 1e-6);
  }
}

TEST(Fitted, IgnoresAFewStrayPoints) {
  auto points = PointsInBox({0, 0, 0}, {10, 5, 2}, 5000);
  const Camera without = Fitted(TopView({1000, 600}), points);
  points.insert(points.end(), 3, {800, -900, 400});
  const Camera with = Fitted(TopView({1000, 600}), points);
  EXPECT_NEAR(with.scale, without.scale, 0.02 * without.scale);
  const Camera all = Fitted(TopView({1000, 600}), points, {.outlier_share = 0.0});
  EXPECT_LT(all.scale, 0.1 * without.scale);
}

TEST(Fitted, CutsTheHeightToTheContent) {
  const auto points = PointsInBox({0, 0, 0}, {20, 2, 2}, 500);
  const FitOptions options{.outlier_share = 0.0, .margin = 20, .adjust_height = true};
  const Camera camera = Fitted(TopView({1040, 900}), points, options);
  EXPECT_EQ(camera.width, 1040);
  EXPECT_NEAR(camera.height, 2 * 50 + 40, 1);
  const PixelBox box = Projected(camera, points);
  EXPECT_NEAR(box.top, 20, 1);
  EXPECT_NEAR(box.bottom, camera.height - 20, 1);
}

TEST(Fitted, KeepsTallPicturesOnThePage) {
  const auto points = PointsInBox({0, 0, 0}, {1, 50, 2}, 500);
  const Camera camera =
      Fitted(TopView({500, 300}), points, {.outlier_share = 0.0, .margin = 20, .adjust_height = true});
  EXPECT_EQ(camera.height, 1000);
  EXPECT_NEAR(Projected(camera, points).top, 20, 1e-6);
}

TEST(Fitted, ManagesOnePointAndNone) {
  for (const Camera& camera : {TopView({400, 300}), ObliqueView({5, 5, 5}, {.size = {400, 300}})}) {
    const PixelBox box = Projected(Fitted(camera, {{1, 2, 3}}), {{1, 2, 3}});
    EXPECT_NEAR(box.left, 200, 1e-6);
    EXPECT_NEAR(box.top, 150, 1e-6);
    EXPECT_EQ(Fitted(camera, {}).scale, camera.scale);
  }
}

TEST(Fitted, RefusesWhatCannotBeShown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        Fitted(TopView({400, 300}), {{0, 0, 0}, {0, nan, 0}});
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("point 1")));
  EXPECT_THAT(
      [] {
        Fitted(TopView({400, 300}), {{0, 0, 0}}, {.margin = 150});
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("no room within margins of 150")));
  EXPECT_THROW(Fitted(TopView({400, 300}), {}, {.outlier_share = 0.7}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
