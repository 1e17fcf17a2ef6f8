#include "experiments/render/camera.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

void ExpectAt(const ImagePoint& point, double u, double v, double depth) {
  EXPECT_NEAR(point.u, u, 1e-9);
  EXPECT_NEAR(point.v, v, 1e-9);
  EXPECT_NEAR(point.depth, depth, 1e-9);
}

TEST(TopView, LooksDownWithNorthUp) {
  const Projector project(TopView({200, 100}, Up::kPlusY, {1, 2, 3}, 10.0));
  ExpectAt(project({1, 2, 3}), 100, 50, 0);
  ExpectAt(project({2, 2, 3}), 110, 50, 0);  // +x to the right
  ExpectAt(project({1, 3, 3}), 100, 40, 0);  // +y up
  ExpectAt(project({1, 2, 1}), 100, 50, 2);  // lower is further away
}

TEST(TopView, CanHaveForwardUp) {
  const Projector project(TopView({200, 100}, Up::kPlusX, {0, 0, 0}, 10.0));
  ExpectAt(project({1, 0, 0}), 100, 40, 0);
  ExpectAt(project({0, 1, 0}), 90, 50, 0);  // left of the robot is left in the picture
}

TEST(LookAt, ShrinksWithDistance) {
  const double right_angle = std::numbers::pi / 2;
  const Projector project(LookAt({0, 0, 1}, {10, 0, 1}, {0, 0, 1}, right_angle, {400, 300}));
  ExpectAt(project({10, 0, 1}), 200, 150, 10);
  ExpectAt(project({10, 10, 1}), 0, 150, 10);  // 45 deg to the left is the edge of the picture
  ExpectAt(project({20, 10, 1}), 100, 150, 20);
  ExpectAt(project({10, 0, 6}), 200, 50, 10);
  EXPECT_FALSE(project.InFront(project({-1, 0, 1}).depth));
}

TEST(ObliqueView, SeesTheTargetInTheMiddle) {
  const Eigen::Vector3d target(3, -2, 1);
  for (const auto projection : {Camera::Projection::kOrthographic, Camera::Projection::kPerspective}) {
    const Camera camera = ObliqueView(target, {.projection = projection, .azimuth = 0.0, .distance = 8.0});
    const Projector project(camera);
    ExpectAt(project(target), 800, 600, 8.0);
    EXPECT_LT(project(target + Eigen::Vector3d::UnitZ()).v, 600);
    EXPECT_GT(project(target + Eigen::Vector3d::UnitY()).u, 800) << "from +x, +y is to the right";
  }
}

TEST(Magnified, ScalesPixels) {
  const Camera camera = ObliqueView({0, 0, 0});
  const Eigen::Vector3d p(0.3, -1.2, 0.4);
  const ImagePoint point = Projector(camera)(p);
  ExpectAt(Projector(Magnified(camera, 3))(p), 3 * point.u, 3 * point.v, point.depth);
}

TEST(Camera, RefusesViewsWithoutADirection) {
  EXPECT_THAT(
      [] {
        LookAt({1, 2, 3}, {1, 2, 3}, {0, 0, 1}, 1.0, {});
      },
      ThrowsMessage<Error>(HasSubstr("(1, 2, 3)")));
  EXPECT_THROW(LookAt({0, 0, 0}, {0, 0, 5}, {0, 0, 1}, 1.0, {}), Error);
  EXPECT_THROW(LookAt({0, 0, 0}, {5, 0, 0}, {0, 0, 1}, 4.0, {}), Error);
}

TEST(Camera, RefusesToProjectWithoutAScale) {
  Camera camera;
  camera.scale = 0.0;
  EXPECT_THAT([&] { Projector{camera}; }, ThrowsMessage<Error>(HasSubstr("scale")));
  camera.scale = 1.0;
  camera.T_camera_map.translation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { Projector{camera}; }, ThrowsMessage<Error>(HasSubstr("not finite")));
}

}  // namespace
}  // namespace ariadne::experiments
