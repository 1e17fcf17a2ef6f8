#include "experiments/render/overlay.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "experiments/render/color_map.h"
#include "slam/base/error.h"
#include "tests/experiments/render/colors.h"

namespace ariadne::experiments {
namespace {

Camera TopOfOverlay() { return TopView({200, 100}, Up::kPlusY, {0, 0, 0}, 10.0); }

slam::Pose3 PoseAt(double x, double y, double yaw = 0.0) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), {x, y, 0}};
}

bool Painted(const Image& image, double x, double y) {
  return image.At(static_cast<int>(x), static_cast<int>(y)) != kWhite;
}

TEST(DrawPath, JoinsProjectedPoints) {
  Image image(200, 100);
  DrawPath(image, TopOfOverlay(), {{-5, 0, 0}, {0, 0, 0}, {0, 3, 0}}, {.color = kRed, .width = 2.0});
  EXPECT_EQ(image.At(70, 50), kRed);
  EXPECT_EQ(image.At(100, 30), kRed);
  EXPECT_EQ(image.At(130, 50), kWhite);
  EXPECT_EQ(image.At(100, 15), kWhite);
}

TEST(DrawPath, IsCutBehindAPerspectiveCamera) {
  const Camera camera = LookAt({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 1.2, {200, 100});
  Image image(200, 100);
  DrawPath(image, camera, {{10, 1, 0}, {-10, 1, 0}}, {.color = kRed, .width = 2.0});
  const ImagePoint start = Projector(camera)({10, 1, 0});
  EXPECT_EQ(image.At(static_cast<int>(start.u) - 2, 50), kRed);
  EXPECT_EQ(image.At(2, 50), kRed) << "it leaves the picture to the left";
  EXPECT_EQ(image.At(static_cast<int>(start.u) + 5, 50), kWhite);
  Image reversed(200, 100);
  DrawPath(reversed, camera, {{-10, 1, 0}, {10, 1, 0}}, {.color = kRed, .width = 2.0});
  EXPECT_EQ(reversed.At(2, 50), kRed);
  EXPECT_EQ(reversed.At(static_cast<int>(start.u) + 5, 50), kWhite);
  Image behind(200, 100);
  DrawPath(behind, camera, {{-1, 0, 0}, {-5, 0, 0}});
  EXPECT_EQ(behind, Image(200, 100));
}

TEST(DrawBox, DrawsTheTwelveEdges) {
  Image image(200, 100);
  DrawBox(image, TopOfOverlay(), {Eigen::Vector3d(-4, -2, 0), Eigen::Vector3d(4, 2, 1)},
          {.color = kRed, .width = 2.0});
  EXPECT_EQ(image.At(60, 50), kRed);
  EXPECT_EQ(image.At(139, 50), kRed);
  EXPECT_EQ(image.At(100, 30), kRed);
  EXPECT_EQ(image.At(100, 69), kRed);
  EXPECT_EQ(image.At(100, 50), kWhite);
}

TEST(DrawPoses, MarksStandWherePosesProject) {
  Image image(200, 100);
  DrawPoses(image, TopOfOverlay(), {PoseAt(-5, 0), PoseAt(5, 2)}, {.radius = 8, .show_numbers = false});
  EXPECT_EQ(image.At(50, 50), CategoricalColor(0));
  EXPECT_EQ(image.At(150, 30), CategoricalColor(1));
  EXPECT_EQ(image.At(100, 50), kWhite);
}

TEST(DrawPoses, TrianglesPointAhead) {
  const double quarter = std::numbers::pi / 2;
  for (const auto& [yaw, x, y] :
       {std::tuple{0.0, 1, 0}, {quarter, 0, -1}, {2 * quarter, -1, 0}, {-quarter, 0, 1}}) {
    Image image(200, 100);
    DrawPoses(image, TopOfOverlay(), {PoseAt(0, 0, yaw)}, {.radius = 8, .show_numbers = false});
    EXPECT_TRUE(Painted(image, 100 + 12 * x, 50 + 12 * y)) << yaw;
    EXPECT_FALSE(Painted(image, 100 - 12 * x, 50 - 12 * y)) << yaw;
  }
}

TEST(DrawPoses, AreNumbered) {
  const PoseStyle style{.radius = 10, .colored_by_index = false};
  Image zero(200, 100), one(200, 100), seven(200, 100);
  DrawPoses(zero, TopOfOverlay(), {PoseAt(0, 0)}, style);
  PoseStyle from_one = style;
  from_one.first_number = 1;
  DrawPoses(one, TopOfOverlay(), {PoseAt(0, 0)}, from_one);
  EXPECT_NE(zero, one);
  EXPECT_GT(std::count(one.pixels.begin(), one.pixels.end(), style.color), 100);
}

TEST(DrawPoses, RefusesPosesThatAreNotFinite) {
  Image image(200, 100);
  EXPECT_THAT(
      [&] {
        DrawPoses(image, TopOfOverlay(),
                  {PoseAt(0, 0), PoseAt(std::numeric_limits<double>::infinity(), 0)});
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("pose 1")));
  EXPECT_THROW(
      DrawPath(image, TopOfOverlay(), {{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}),
      Error);
}

}  // namespace
}  // namespace ariadne::experiments
