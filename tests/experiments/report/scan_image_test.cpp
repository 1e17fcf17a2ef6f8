#include "experiments/report/scan_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

/// Three slices of five beams, from below to above; the reflectance rises with the beam, hence to the left.
slam::Scan SmallScan() {
  slam::Scan scan;
  scan.scanner.angle_step = std::numbers::pi / 4.0;
  for (const double pitch : {-0.2, 0.0, 0.2}) {
    slam::LaserSweep sweep;
    sweep.pitch = pitch;
    sweep.ranges.assign(5, 2.0F);
    sweep.reflectance = {0.0F, 0.25F, 0.5F, 0.75F, 1.0F};
    scan.sweeps.push_back(sweep);
  }
  return scan;
}

TEST(DistortedReflectance, HasARowPerSliceTheHighestOnTop) {
  slam::Scan scan = SmallScan();
  scan.sweeps[2].ranges[2] = slam::LaserSweep::kNoReturn;  // of the highest slice, in the middle
  const Image image = DistortedReflectance(scan);
  ASSERT_EQ(image.width, 5);
  ASSERT_EQ(image.height, 3);
  EXPECT_EQ(image.At(2, 0), kBlack);
  EXPECT_NE(image.At(2, 1), kBlack);
  EXPECT_GT(image.At(0, 1).r, image.At(4, 1).r) << "the last beam is the leftmost";
}

TEST(DistortedReflectance, HasTheHighestOnTopWhateverTheDirectionOfTheTilt) {
  slam::Scan scan = SmallScan();
  scan.sweeps[2].ranges[2] = slam::LaserSweep::kNoReturn;
  slam::Scan downwards = scan;
  std::swap(downwards.sweeps[0], downwards.sweeps[2]);
  EXPECT_EQ(DistortedReflectance(scan), DistortedReflectance(downwards));
}

TEST(CorrectedReflectance, DrawsLeftWhatIsLeft) {
  slam::Scan scan = SmallScan();
  for (slam::LaserSweep& sweep : scan.sweeps) {
    for (const std::size_t beam : {0, 1, 2, 4}) sweep.ranges[beam] = slam::LaserSweep::kNoReturn;
  }
  const Image image = CorrectedReflectance(scan, 200, 100, 2.5);  // 45 deg to the left is in it
  int left = 0, right = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) (x < 100 ? left : right) += image.At(x, y) == kBlack ? 0 : 1;
  }
  EXPECT_GT(left, 0);
  EXPECT_EQ(right, 0);
}

TEST(DistortedReflectance, SaysThatThereIsNoReflectance) {
  slam::Scan scan = SmallScan();
  scan.sweeps[1].reflectance.clear();
  EXPECT_THAT(ErrorOf([&] { DistortedReflectance(scan); }), testing::HasSubstr("no reflectance"));
  EXPECT_THAT(ErrorOf([] { DistortedReflectance({}); }), testing::HasSubstr("empty"));
}

}  // namespace
}  // namespace ariadne::experiments
