#include "experiments/render/eye_dome.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ariadne::experiments {
namespace {

constexpr Rgb kLightGray{200, 200, 200};
constexpr int kSide = 40;  // of the picture [px]

/// Looks down with 100 px per metre, so a pixel is 1 cm wide.
Camera TopOfPicture() { return TopView({kSide, kSide}, Up::kPlusY, {0, 0, 0}, 100.0); }

/// A gray frame whose depth is given for each pixel.
template <typename Depth>
Frame FrameOf(const Depth& depth) {
  Frame frame(TopOfPicture(), kLightGray);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      frame.depth[frame.color.IndexOf(x, y)] = static_cast<float>(depth(x, y));
  }
  return frame;
}

TEST(EyeDome, LeavesPlanesAsTheyAre) {
  Frame level = FrameOf([](int, int) { return 2.0; });
  ShadeEyeDome(level, TopOfPicture(), {});
  EXPECT_EQ(level.color, Image(kSide, kSide, kLightGray));
  Frame tilted = FrameOf([](int x, int y) { return 0.015625 * x + 0.0625 * y; });
  ShadeEyeDome(tilted, TopOfPicture(), {});
  EXPECT_EQ(tilted.color, Image(kSide, kSide, kLightGray));
}

TEST(EyeDome, DarkensTheFarSideOfAnEdge) {
  Frame frame = FrameOf([](int x, int) { return x < 20 ? 1.0 : 2.0; });
  ShadeEyeDome(frame, TopOfPicture(), {});
  EXPECT_EQ(frame.color.At(19, 20), kLightGray) << "the near side";
  EXPECT_LT(frame.color.At(20, 20).r, 120);
  EXPECT_EQ(frame.color.At(23, 20), kLightGray) << "further away than the radius";
}

TEST(EyeDome, IgnoresStepsBelowTheGrain) {
  Frame frame = FrameOf([](int x, int) { return x < 20 ? 1.0 : 1.04; });
  Frame rough = frame;
  ShadeEyeDome(frame, TopOfPicture(), {});
  EXPECT_LT(frame.color.At(20, 20).r, 190);
  std::fill(rough.grain.begin(), rough.grain.end(), 0.05F);
  ShadeEyeDome(rough, TopOfPicture(), {});
  EXPECT_EQ(rough.color, Image(kSide, kSide, kLightGray));
}

TEST(EyeDome, LeavesTheBackgroundAndEdgesAgainstIt) {
  Frame frame = FrameOf([](int x, int) { return x < 20 ? 1.0 : Frame::kBackground; });
  ShadeEyeDome(frame, TopOfPicture(), {.strength = 3.0});
  EXPECT_EQ(frame.color, Image(kSide, kSide, kLightGray));
}

TEST(EyeDome, DarkensAStripBetweenSomethingNearAndTheBackground) {
  Frame frame = FrameOf([](int x, int) { return x < 20 ? 1.0 : x < 22 ? 2.0 : Frame::kBackground; });
  ShadeEyeDome(frame, TopOfPicture(), {});
  EXPECT_NEAR(frame.color.At(21, 20).r, 200 * std::exp(-0.5), 2) << "one of four pairs lies in a hollow";
}

TEST(EyeDome, CanBeOff) {
  Frame frame = FrameOf([](int x, int) { return x < 20 ? 1.0 : 2.0; });
  ShadeEyeDome(frame, TopOfPicture(), {.strength = 0.0});
  EXPECT_EQ(frame.color, Image(kSide, kSide, kLightGray));
}

TEST(EyeDome, ManagesPicturesSmallerThanItsRadius) {
  const Camera tiny = TopView({3, 50}, Up::kPlusY, {0, 0, 0}, 100.0);
  Frame frame(tiny, kLightGray);
  std::fill(frame.depth.begin(), frame.depth.end(), 1.0F);
  ShadeEyeDome(frame, tiny, {.radius = 10.0});
  EXPECT_EQ(frame.color, Image(3, 50, kLightGray));
}

}  // namespace
}  // namespace ariadne::experiments
